// What: writes a drawing as SVG or PNG.
// Law:  a scene always gives the same bytes of SVG, and the same pixels. Positions in SVG are multiples of 0.01 pixels.
// How:  SVG has one path for each layer; for PNG an own rasterizer smooths the edges.
#pragma once

#include <cstdint>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "picture/drawing.h"
#include "picture/scene.h"

namespace rbpa::app {

inline bool is_picture(Format format) { return format == Format::svg || format == Format::png; }

/// Writes the scene. Throws as OutputFile::write() does.
void write_svg(OutputFile& file, const Scene& scene);

/// Writes a picture. `pixels` has red, green and blue of each pixel, by rows. Throws Failure if the picture cannot be
/// encoded; as OutputFile does; Cancelled.
void write_png(OutputFile& file, int width, int height, const std::vector<std::uint8_t>& pixels);
void write_png(OutputFile& file, const Scene& scene);

/// Writes the scene. Requires: is_picture(format). Throws as write_svg() and write_png() do; Cancelled.
inline void write_picture(OutputFile& file, Format format, const Scene& scene) {
  format == Format::svg ? write_svg(file, scene) : write_png(file, scene);
}

}  // namespace rbpa::app
