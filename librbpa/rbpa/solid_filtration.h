// What:   the alpha complex of points in space at every radius: its edges and triangles, and the radius at which each simplex comes into it.
// Law:    a simplex is in the full alpha complex of alpha exactly if its radius is at most alpha, for every double alpha: it is rounded up from the exact one.
//         No simplex has a greater radius than one that it is a face of. A function of the set of points and of their numbering.
// Cost:   linear in the tetrahedra, shared among threads; microseconds a simplex where points are cospherical.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4; docs/persistence_in_space.md.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/solid.h"

namespace rbpa {

struct SolidFiltration {
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< ascending, in lexicographic order
  std::vector<double> edge_alpha;
  std::vector<Triangle>
      triangles;  ///< ascending; in the order of their first tetrahedra, and there of the corner across
  std::vector<double> triangle_alpha;
  std::vector<double> tetrahedron_alpha;  ///< circumradii(), of the triangulation's
  /// Of each tetrahedron, the triangle across from each corner.
  std::vector<std::array<std::uint32_t, 4>> triangles_of;
};

/// Requires: the result of solid() at infinity, with neighbors, which is not empty unless there are fewer than two distinct points. `threads` as in
///           SolidOptions.
/// Throws:   ContractViolation where neighbors are missing; InvalidInput when several points have no tetrahedron, as those of a plane.
RBPA_API SolidFiltration solid_filtration(std::span<const Point3> points, const Solid& delaunay, unsigned threads = 0);

}  // namespace rbpa
