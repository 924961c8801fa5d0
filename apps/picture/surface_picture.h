// What: draws a surface in space as PNG: shaded triangles in the colors of the points if they have any, filled holes
//       and the boundary in colors of their own, points in no triangle as dots.
// Law:  the same triangles give the same pixels, in whatever order they come, except where triangles have the same
//       depth.
// Cost: linear in the pixels that the triangles cover, four samples each (one sample each in pictures wider than 4096
//       pixels).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

struct SurfacePicture {
  std::span<const Point3> points;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const std::array<std::uint32_t, 2>> rims, holes,
      islands;  ///< boundary sides, as pairs of point numbers, by kind of their curve
  std::span<const std::uint32_t> unused;
  std::span<const std::array<std::uint8_t, 3>>
      colors;                       ///< one for each point, or empty; shown on the front of triangles
  const std::vector<bool>& filled;  ///< tells for each triangle whether it fills a hole; empty if none does
};

/// Writes the picture. Requires: least_width ≤ width ≤ greatest_width (scene.h). Throws what OutputFile::write()
/// throws.
void write_surface_png(OutputFile& file, const SurfacePicture& picture, int width);

}  // namespace rbpa::app
