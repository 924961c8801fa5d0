// What: which triangle makes each void, and which tetrahedron fills it at last.
// How:  backwards in alpha, tetrahedra that are left out are joined by the triangles between them: where two voids are parted, that is a birth, and
//       the one whose last tetrahedron comes first ends with it. A triangle of the same radius as one of its tetrahedra joins that to what is across at once,
//       without any length of life. So each tetrahedron goes first, without a sort, to the last one in its basin, and only triangles between basins are sorted.
// Law:  the triangles that join are the greatest spanning forest of the dual graph, in the order of the filtration; a tetrahedron's greatest triangle is in it.
// Cost: linear, and a sort of the triangles between basins, about a quarter of all.
// Source: Delfinado, Edelsbrunner (1995); Borůvka (1926); Dey, Giesen, Goswami, Shape segmentation and matching with flow discretization (2003): basins.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/solid.h"

namespace rbpa::space {

struct PersistentVoid {
  std::uint32_t triangle, tetrahedron;
  std::uint32_t parted_from;  ///< the last tetrahedron of what it was in before, or none: the outside
};

struct PersistentVoids {
  std::vector<PersistentVoid> all;   ///< by triangle, backwards in the order of the filtration; some have no length
  std::vector<bool> makes_one;       ///< of each triangle; the others end a tunnel
  std::vector<std::uint32_t> basin;  ///< of each tetrahedron, the last one of its basin, or none: the outside
};

/// With a radius for each tetrahedron, the numbers of its triangles, and a radius for each of those, at most that of each of its tetrahedra.
PersistentVoids find_voids(const Solid& delaunay, std::span<const double> radii,
                           std::span<const std::array<std::uint32_t, 4>> triangles_of,
                           std::span<const double> triangle_radii, Steps& step);

}  // namespace rbpa::space
