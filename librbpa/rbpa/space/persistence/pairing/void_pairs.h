// What: finds the triangle that makes each void, and the last of the tetrahedra that fill it.
// How:  in descending alpha, tetrahedra leave the complex and are joined through the triangles between them. A triangle
//       that joins two voids makes the void whose last tetrahedron comes first; the void lives from the triangle to
//       that tetrahedron. A triangle with the same radius as one of its tetrahedra joins it to the tetrahedron across
//       at once, with persistence 0. So each tetrahedron is first assigned, without a sort, to the last tetrahedron of
//       its basin, and only triangles between basins are sorted.
// Law:  the triangles that join are the maximum spanning forest of the dual graph, in the order of the filtration; the
//       greatest triangle of each tetrahedron is in it.
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
  std::uint32_t triangle, tetrahedron;  ///< the triangle that makes it; the last tetrahedron that fills it
  std::uint32_t parted_from;            ///< the last tetrahedron of the void that it was part of; none: the outside
};

struct PersistentVoids {
  std::vector<PersistentVoid> all;   ///< by triangle, in descending order of the filtration; some have persistence 0
  std::vector<bool> makes_one;       ///< for each triangle: whether it makes a void; the others end a tunnel
  std::vector<std::uint32_t> basin;  ///< for each tetrahedron, the last one of its basin; none: the outside
};

/// Returns the voids. Requires: `delaunay` has neighbors; `radii` are those of its tetrahedra; `triangles_of` is
/// NumberedTriangles::of; the radius of a triangle is at most those of its tetrahedra.
PersistentVoids find_voids(const Solid& delaunay, std::span<const double> radii,
                           std::span<const std::array<std::uint32_t, 4>> triangles_of,
                           std::span<const double> triangle_radii, Steps& step);

}  // namespace rbpa::space
