// What: writes a scene as SVG, with one path for each layer.
// Law:  a scene always gives the same bytes. Positions are multiples of 0.01 pixels.
#pragma once

#include "io/bytes/output_file.h"
#include "picture/scene.h"

namespace rbpa::app {

/// Writes the scene. Throws as OutputFile::write() does.
void write_svg(OutputFile& file, const Scene& scene);

}  // namespace rbpa::app
