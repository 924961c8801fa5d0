// What: draws a surface in space as PNG: shaded triangles in the colors of the points if they have any, filled holes
//       and the boundary in colors of their own, points in no triangle as dots.
// Law:  the same triangles give the same pixels, in any order but for triangles at the same depth.
// Cost: the pixels that the triangles cover, four samples each (one in pictures wider than 4096).
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
  std::span<const std::array<std::uint32_t, 2>> rims, holes, islands;  ///< boundary sides by kind
  std::span<const std::uint32_t> unused;
  std::span<const std::array<std::uint8_t, 3>>
      colors;                       ///< one for each point, or empty; shown on the front of triangles
  const std::vector<bool>& filled;  ///< for each triangle whether it fills a hole; empty: none does
};

/// Writes the picture. Requires: a width within the bounds of scene.h. Throws as OutputFile does, Cancelled.
void write_surface_png(OutputFile& file, const SurfacePicture& picture, int width);

}  // namespace rbpa::app
