// What: tetrahedra in arrays, each with the minors of its circumsphere (space/predicate/sphere_minors.h).
// How:  a corner may be at infinity: the tetrahedron is then a ghost over a face of the hull, and its sphere is the
//       half-space beyond. Corner 3 is never at infinity; the minors are relative to it.
//
//         minor 32 | corner 16 | neighbor 16      a cache line
//         error 8                                 an array of its own
#pragma once

#include <array>
#include <cstdint>

#include "rbpa/space/predicate/sphere_minors.h"

namespace rbpa::space {

/// A vertex: 0 is at infinity; the others are points, numbered from 1 in the order of insertion.
using Vertex = std::uint32_t;
inline constexpr Vertex at_infinity = 0;

/// A face of a tetrahedron: 4 · (its number) + (the corner across from it).
using Face = std::uint32_t;

struct alignas(64) Tetrahedron {
  SphereMinors minor;
  std::array<Vertex, 4> corner;
  std::array<Face, 4> neighbor;  ///< the face across from each corner, named by the neighbor

  bool is_ghost() const {  // corner 3 is a point
    return corner[0] == at_infinity || corner[1] == at_infinity || corner[2] == at_infinity;
  }
};

/// A point in the form that the insertion uses.
struct alignas(32) InsertedPoint {
  double x, y, z;
  std::uint32_t last_insertion = 0;  ///< the last insertion with it on the boundary of the cavity
  std::uint32_t local = 0;           ///< its number in that boundary
};

/// A ball in that form.
struct InsertedBall : InsertedPoint {
  double radius = 0;
};

}  // namespace rbpa::space
