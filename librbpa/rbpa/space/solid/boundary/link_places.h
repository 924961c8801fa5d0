// What: decides where one part of a point's link lies relative to another. The link is the set of directions from the
//       point, on a sphere, in which there are tetrahedra.
// Law:  exact, on any finite input.
// Cost: up to nine orientations for each triangle.
// How:  the crossings of an arc with each closed curve of the link's boundary are counted. The arc leads from a
//       direction within a tetrahedron of one part to a direction within a tetrahedron of the other part. The
//       directions are moved off the edges of the tetrahedra by infinitesimals of different orders, so that the arc
//       never passes through a corner. docs/explanation/space.md, section 19.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// The three corners of a tetrahedron other than `center`, the point whose link is examined.
using LinkTriangle = std::array<std::uint32_t, 3>;

/// Returns whether the arc from a direction within `from` to a direction within `to` crosses the arc from p to q. A
/// point stands for its direction from `center`.
/// Requires: neither triangle is in a plane with `center`; p, q and `center` are on no line.
bool arcs_cross(std::span<const Point3> points, std::uint32_t center, const LinkTriangle& from, const LinkTriangle& to,
                std::uint32_t p, std::uint32_t q);

}  // namespace rbpa::space
