// What: stores tetrahedra in arrays, each with the minors of its circumsphere (space/predicate/sphere_minors.h).
// How:  a corner may be at infinity: the tetrahedron is then a ghost over a face of the hull, and its sphere is the
//       half-space beyond the face. Corner 3 is never at infinity; the minors are relative to corner 3.
//
//         minor 32 | corner 16 | neighbor 16      a cache line
//         error 8                                 an array of its own
#pragma once

#include <array>
#include <cstdint>

#include "rbpa/space/predicate/sphere_minors.h"

namespace rbpa::space {

/// The number of a vertex: 0 for the vertex at infinity; points are numbered from 1 in the order of insertion.
using Vertex = std::uint32_t;
inline constexpr Vertex at_infinity = 0;

/// The number of a face: 4 · (number of the tetrahedron) + (corner of the tetrahedron across from the face).
using Face = std::uint32_t;

struct alignas(64) Tetrahedron {
  SphereMinors minor;
  std::array<Vertex, 4> corner;
  std::array<Face, 4> neighbor;  ///< the face across from each corner, as a face of the neighbor

  bool is_ghost() const {  // corner 3 is never at infinity
    return corner[0] == at_infinity || corner[1] == at_infinity || corner[2] == at_infinity;
  }
};

/// A point in the form that the insertion uses.
struct alignas(32) InsertedPoint {
  double x, y, z;
  std::uint32_t last_insertion = 0;  ///< the last vertex whose cavity has this point on its boundary
  std::uint32_t local = 0;           ///< number of this point on the boundary of that cavity
};

/// A ball in the form that the insertion uses.
struct InsertedBall : InsertedPoint {
  double radius = 0;
};

}  // namespace rbpa::space
