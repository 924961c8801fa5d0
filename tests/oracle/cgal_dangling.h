// What: the dangling simplices of the full alpha complex, those that are faces of no other simplex of it, by CGAL's
//       Alpha_shape_3.
// Law:  shares no code with the library.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_test {

/// Dangling simplices: each with ascending indices, sorted.
struct DanglingByCgal {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> points;
};

/// The alpha shapes of points at any alpha. Requires: distinct points, not all in a plane.
class AlphaShapeByCgal {
 public:
  explicit AlphaShapeByCgal(std::span<const rbpa::Point3> points);
  ~AlphaShapeByCgal();
  AlphaShapeByCgal(const AlphaShapeByCgal&) = delete;
  AlphaShapeByCgal& operator=(const AlphaShapeByCgal&) = delete;

  /// Returns the dangling simplices. Requires: an alpha whose square is a double.
  DanglingByCgal dangling(double alpha);

 private:
  struct Shape;
  std::unique_ptr<Shape> shape_;
};

}  // namespace rbpa_test
