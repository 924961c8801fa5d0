// What: where the vertices of a complex stand, in the coordinates the user gave.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "rbpa/base/point.h"
#include "rbpa/rbpa.h"

namespace rbpa {

class Corners {
 public:
  /// Throws: ContractViolation when the complex does not stand on these points.
  Corners(const SolidAlphaComplex& complex, std::span<const Point> points) : complex_(complex), points_(points) {
    for (std::size_t v = 0; v < complex.input_index.size(); ++v) {
      const auto at = complex.mesh.point(meshops::Vertex(static_cast<int>(v)));
      const std::uint32_t i = complex.input_index[v];
      meshops::require(i < points.size() && points[i] == Point{at[0], at[1]},
                       "filtration: the complex is of other points than those given");
    }
  }

  const Point& of_vertex(meshops::Vertex v) const {
    return points_[complex_.input_index[static_cast<std::size_t>(v.idx())]];
  }

  std::array<Point, 3> of_face(std::uint32_t face) const {
    const Mesh& mesh = complex_.mesh;
    const auto h = mesh.halfedge_handle(meshops::Face(static_cast<int>(face)));
    return {of_vertex(mesh.from_vertex_handle(h)), of_vertex(mesh.to_vertex_handle(h)),
            of_vertex(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)))};
  }

 private:
  const SolidAlphaComplex& complex_;
  std::span<const Point> points_;
};

/// Of corners in any order, always rounded alike; long double, as it is a product of two coordinates.
inline long double area(std::array<Point, 3> corners) {
  std::sort(corners.begin(), corners.end());
  const auto& [a, b, c] = corners;
  using Wide = long double;
  const Wide cross =
      (Wide(b.x) - Wide(a.x)) * (Wide(c.y) - Wide(a.y)) - (Wide(b.y) - Wide(a.y)) * (Wide(c.x) - Wide(a.x));
  return std::abs(cross) / 2;
}

}  // namespace rbpa
