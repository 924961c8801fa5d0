// What:   the alpha complex of points in space at every radius: all simplices of their Delaunay triangulation, what is a face of what, and the radius at which each
//         comes into the complex.
//         Of points in a plane or on a line the triangles and edges are those of their Delaunay triangulation there.
// Law:    a simplex is in the full alpha complex of alpha exactly if its radius is at most alpha, for every double alpha: it is rounded up from the exact one.
//         No simplex has a greater radius than one that it is a face of. A function of the set of points, and of their numbering.
// Cost:   that of solid(), and about as much again (docs/persistence_in_space.md); radii are shared among threads.
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
  /// The tetrahedra of solid() at infinity, with neighbors, but along a space-filling curve in place of lexicographic order: what follows has them, and
  /// each other, near by in memory. Positively oriented, from any corner on. None where all points are in a plane.
  Solid delaunay;
  std::vector<double> tetrahedron_alpha;
  std::vector<Triangle> triangles;  ///< ascending corners; in the order of their first tetrahedra
  std::vector<double> triangle_alpha;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< ascending; in the order of their first triangles
  std::vector<double> edge_alpha;

  std::vector<std::array<std::uint32_t, 4>> triangles_of;  ///< of each tetrahedron, across from each corner
  std::vector<std::array<std::uint32_t, 3>> edges_of;      ///< of each triangle, likewise
};

/// Options as in solid(); neighbors are always there. `progress` is called with all points once they are triangulated.
/// Throws: as solid().
RBPA_API SolidFiltration solid_filtration(std::span<const Point3> points, const SolidOptions& options = {});

}  // namespace rbpa
