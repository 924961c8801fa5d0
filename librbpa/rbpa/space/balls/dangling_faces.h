// What:   finds the dangling simplices of the full alpha complex: triangles in no tetrahedron, edges in no triangle,
//         points in no edge.
// Law:    a simplex is in the full alpha complex exactly if some ball of radius at most alpha has all its corners on
//         the sphere and no point inside. Exact, for any finite input.
// Cost:   about linear in the Delaunay triangulation; microseconds a simplex where points are cospherical.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994); docs/explanation/space.md, section 21.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// The dangling simplices, as ascending input indices in lexicographic order.
struct DanglingFaces {
  std::vector<Triangle> triangles;                  ///< in no tetrahedron of the complex
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< in no triangle of the complex
  std::vector<std::uint32_t> points;                ///< in no edge of the complex
};

/// Computes the dangling simplices at `alpha`. If there is no tetrahedron, as for points in a plane, the complex
/// consists of the simplices of solid_filtration() with a radius of at most alpha.
/// Requires: `delaunay` is solid() of these points at infinity, with neighbors; `radii` are its circumradii(); 0 <
///           alpha ≤ infinity.
/// Throws:   ContractViolation if radii, neighbors or the point of a corner are missing; InvalidInput if alpha is not
///           above 0. The other requirements are not checked.
RBPA_API DanglingFaces dangling_faces(std::span<const Point3> points, const Solid& delaunay,
                                      std::span<const double> radii, double alpha, MaxThreads threads = 0);

}  // namespace rbpa
