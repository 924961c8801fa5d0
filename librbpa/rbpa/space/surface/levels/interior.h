// What: finds the interior points and edges of a surface, at which no other triangle can be glued.
// Law:  a point is interior if a fan of triangles around the point is closed; an edge, if two sides are glued along it.
// Cost: linear, and a sort of the edges near the boundary.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "rbpa/base/triangle_arrays.h"

namespace rbpa::space {

class Interior {
 public:
  /// Finds the interior points and edges. Requires: linked triangles whose corners are below `points`.
  Interior(const TriangleArrays& of, std::size_t points);

  bool has_point(std::uint32_t point) const { return points_[point] != 0; }
  /// Returns whether the edge is interior. Requires: neither end of the edge is an interior point.
  bool has_edge(std::uint32_t from, std::uint32_t to) const;
  /// Returns a value for each point by index: nonzero if the point is interior.
  const std::vector<std::uint8_t>& points() const { return points_; }

 private:
  std::vector<std::uint8_t> points_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;  // interior edges between points that are not; sorted
};

}  // namespace rbpa::space
