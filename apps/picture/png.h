// What: writes a scene as PNG with our own anti-aliasing rasterizer.
// Law:  the same scene gives the same pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "io/bytes/output_file.h"
#include "picture/scene.h"

namespace rbpa::app {

/// Writes a picture, of which `pixels` has red, green and blue of each pixel, by rows. Throws Failure if it cannot be
/// encoded, and as OutputFile does.
void write_png(OutputFile& file, int width, int height, const std::vector<std::uint8_t>& pixels);

void write_png(OutputFile& file, const Scene& scene);

}  // namespace rbpa::app
