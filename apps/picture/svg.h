// What: writes a scene as SVG, one path per layer.
// Law:  the same scene gives the same bytes. Positions are multiples of 0.01 pixels.
#pragma once

#include "io/bytes/output_file.h"
#include "picture/scene.h"

namespace rbpa::app {

/// Writes the scene. Throws as OutputFile::write().
void write_svg(OutputFile& file, const Scene& scene);

}  // namespace rbpa::app
