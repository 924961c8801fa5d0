// What: a scene as PNG, drawn by our own anti-aliasing rasteriser.
// Law:  the same scene gives the same pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "io/bytes/output_file.h"
#include "picture/scene.h"

namespace rbpa::app {

/// Red, green and blue of each pixel, by rows.
void write_png(OutputFile& file, int width, int height, const std::vector<std::uint8_t>& pixels);

void write_png(OutputFile& file, const Scene& scene);

}  // namespace rbpa::app
