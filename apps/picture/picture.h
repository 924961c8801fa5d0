// What: writes a drawing as SVG or PNG.
#pragma once

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "picture/drawing.h"
#include "picture/png.h"
#include "picture/scene.h"
#include "picture/svg.h"

namespace rbpa::app {

inline bool is_picture(Format format) { return format == Format::svg || format == Format::png; }

/// Writes the scene. Requires: is_picture(format). Throws as write_svg() and write_png() do; Cancelled.
inline void write_picture(OutputFile& file, Format format, const Scene& scene) {
  format == Format::svg ? write_svg(file, scene) : write_png(file, scene);
}

}  // namespace rbpa::app
