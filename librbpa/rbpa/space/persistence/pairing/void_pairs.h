// What: finds the triangle that makes each void, and the last of the tetrahedra that fill the void.
// How:  simplices leave the complex in descending alpha, and triangles join the tetrahedra on both sides. Of two voids
//       that a triangle joins, the triangle makes the one whose last tetrahedron is earlier; this void lives from the
//       triangle to this tetrahedron. Triangles with the radius of one of their tetrahedra make voids of persistence 0:
//       these triangles join tetrahedra to basins without a sort, and only triangles between basins are sorted.
// Law:  the triangles that join are the maximum spanning tree of the dual graph with the outside, in the order of the
//       filtration. The tree contains the greatest triangle of each tetrahedron.
// Cost: linear, and a sort of the triangles between basins, about a quarter of all.
// Source: Delfinado, Edelsbrunner (1995); Borůvka (1926); Dey, Giesen, Goswami, Shape segmentation and matching with
//         flow discretization (2003): basins.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

struct PersistentVoid {
  std::uint32_t triangle, tetrahedron;  ///< the triangle that makes the void; the last tetrahedron that fills it
  std::uint32_t parted_from;            ///< last tetrahedron of the void from which it separates; none: outside
};

struct PersistentVoids {
  std::vector<PersistentVoid> all;   ///< by triangle, descending in the filtration; some have persistence 0
  std::vector<bool> makes_one;       ///< for each triangle: whether it makes a void; any other ends a tunnel
  std::vector<std::uint32_t> basin;  ///< for each tetrahedron: the last one of its basin; none: the outside
};

/// Returns the voids. Requires: `delaunay` has neighbors; `radii` are those of its tetrahedra; `triangles_of` is
/// NumberedTriangles::of; the radius of a triangle is not above the radii of its tetrahedra.
PersistentVoids find_voids(const Solid& delaunay, std::span<const double> radii,
                           std::span<const std::array<std::uint32_t, 4>> triangles_of,
                           std::span<const double> triangle_radii, Steps& step);

}  // namespace rbpa::space
