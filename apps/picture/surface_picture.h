// What: draws a surface in space as PNG: shaded triangles in the colors of the points, if they have colors; filled
//       holes and the boundary in colors of their own; points in no triangle as dots.
// Law:  a set of triangles always gives the same pixels, whatever their order, except where triangles have equal depth.
// Cost: linear in the pixels that the triangles cover, with four samples for each pixel (one sample in pictures wider
//       than 4096 pixels).
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
      islands;  ///< boundary sides, as pairs of point numbers, by the kind of their curve
  std::span<const std::uint32_t> unused;
  std::span<const std::array<std::uint8_t, 3>>
      colors;                       ///< a color for each point, or empty; shown on the front of triangles
  const std::vector<bool>& filled;  ///< whether each triangle fills a hole; empty if none does
};

/// Writes the picture. Requires: least_width ≤ width ≤ greatest_width (scene.h). Throws as write_png() does; Cancelled.
void write_surface_png(OutputFile& file, const SurfacePicture& picture, int width);

}  // namespace rbpa::app
