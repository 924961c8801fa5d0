// What: walks along the boundary of a triangulation that is given as arrays of triangles and neighbors.
// Law:  at a point where the complex touches itself (a pinch), a walk continues along the same fan of triangles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// The side of a triangle across from a corner.
struct BoundarySide {
  std::uint32_t triangle;
  std::size_t across;  ///< number of the corner, 0 to 2
};

class BoundaryWalk {
 public:
  /// Keeps the spans of `of`. Requires: require_linked() accepts `of`; not checked.
  explicit BoundaryWalk(const TriangleArrays& of) : of_(of), seen_(of.triangles.size(), 0) {}

  /// Returns whether the side is a boundary side that no curve has passed yet.
  bool is_new(const BoundarySide& side) const {
    return neighbor(side) == TriangleArrays::none &&
           (static_cast<unsigned>(seen_[side.triangle]) >> side.across & 1U) == 0;
  }

  /// Returns the points of the whole boundary curve through a new side, in the order that has the triangles on the
  /// right. Afterwards no side of the curve is new.
  std::vector<std::uint32_t> curve_from(const BoundarySide& side) {
    std::vector<std::uint32_t> points;
    walk_from(side, [&](const BoundarySide& at) { points.push_back(of_.triangles[at.triangle][(at.across + 2) % 3]); });
    return points;
  }
  /// Walks along the whole boundary curve of a new side. Calls visit(side) for each side, in the order of curve_from().
  template <typename Visit>
  void walk_from(BoundarySide side, Visit visit) {
    for (; is_new(side); side = side_before(side)) {
      seen_[side.triangle] = static_cast<std::uint8_t>(static_cast<unsigned>(seen_[side.triangle]) | 1U << side.across);
      visit(side);
    }
  }

 private:
  /// Returns the boundary side that ends where `side` begins, at the other end of the fan of triangles at that point.
  BoundarySide side_before(const BoundarySide& side) const {
    const std::uint32_t pivot = of_.triangles[side.triangle][(side.across + 1) % 3];
    BoundarySide at{side.triangle, (side.across + 2) % 3};
    for (std::uint32_t next = neighbor(at); next != TriangleArrays::none; next = neighbor(at)) {
      const auto& corners = of_.triangles[next];
      const auto corner = std::find(corners.begin(), corners.end(), pivot) - corners.begin();
      at = {next, (static_cast<std::size_t>(corner) + 1) % 3};
    }
    return at;
  }
  std::uint32_t neighbor(const BoundarySide& side) const { return of_.neighbors[side.triangle][side.across]; }

  TriangleArrays of_;
  std::vector<std::uint8_t> seen_;  // for each triangle, bit k: a curve has passed the side across from corner k
};

}  // namespace rbpa
