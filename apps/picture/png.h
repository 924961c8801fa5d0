// What: writes a scene as PNG; an own rasterizer smooths the edges.
// Law:  a scene always gives the same pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "io/bytes/output_file.h"
#include "picture/scene.h"

namespace rbpa::app {

/// Writes a picture. `pixels` has red, green and blue of each pixel, by rows. Throws Failure if the picture cannot be
/// encoded; as OutputFile does; Cancelled.
void write_png(OutputFile& file, int width, int height, const std::vector<std::uint8_t>& pixels);

void write_png(OutputFile& file, const Scene& scene);

}  // namespace rbpa::app
