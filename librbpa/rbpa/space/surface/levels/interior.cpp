#include "rbpa/space/surface/levels/interior.h"

#include <algorithm>
#include <cstddef>

namespace rbpa::space {
namespace {

/// Marks the corners of all fans that have two ends: element 3t + k of the result is for corner k of triangle t.
std::vector<std::uint8_t> corners_of_open_fans(const TriangleArrays& of) {
  std::vector<std::uint8_t> is_open(3 * of.triangles.size(), 0);
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      if (of.neighbors[t][k] != TriangleArrays::none) continue;
      // Walks around the corner after corner k, from the side across from corner k to the other end of the fan.
      const std::uint32_t pivot = of.triangles[t][(k + 1) % 3];
      std::uint32_t at = t;
      std::size_t corner = (k + 1) % 3;
      while (true) {
        is_open[3 * at + corner] = 1;
        at = of.neighbors[at][(corner + 1) % 3];
        if (at == TriangleArrays::none) break;
        const auto& corners = of.triangles[at];
        corner = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), pivot) - corners.begin());
      }
    }
  return is_open;
}

}  // namespace

Interior::Interior(const TriangleArrays& of, std::size_t points) : points_(points, 0) {
  const std::vector<std::uint8_t> is_open = corners_of_open_fans(of);
  for (std::size_t i = 0; i < is_open.size(); ++i)
    if (is_open[i] == 0) points_[of.triangles[i / 3][i % 3]] = 1;
  for (std::size_t t = 0; t < of.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = of.triangles[t][(k + 1) % 3], to = of.triangles[t][(k + 2) % 3];
      if (of.neighbors[t][k] != TriangleArrays::none && from < to && !has_point(from) && !has_point(to))
        edges_.emplace_back(from, to);
    }
  std::sort(edges_.begin(), edges_.end());
}

bool Interior::has_edge(std::uint32_t from, std::uint32_t to) const {
  return std::binary_search(edges_.begin(), edges_.end(), std::pair(std::min(from, to), std::max(from, to)));
}

}  // namespace rbpa::space
