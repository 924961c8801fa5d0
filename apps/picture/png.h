// What: a scene as PNG, drawn by our own anti-aliasing rasteriser.
// Law:  the same scene gives the same pixels.
#pragma once

#include "io/output_file.h"
#include "picture/scene.h"

namespace rbpa::app {

void write_png(OutputFile& file, const Scene& scene);

}  // namespace rbpa::app
