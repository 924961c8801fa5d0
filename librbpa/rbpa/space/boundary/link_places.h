// What: where one part of a point's link lies with respect to another: the directions from a point, which are a sphere, in which there are
//       tetrahedra.
// Law:  exact, on any finite input.
// Cost: up to nine orientations for each triangle.
// How:  an arc goes from a direction within a tetrahedron of the one part to a direction within one of the other, and it is counted how
//       often it crosses each closed curve. The directions are moved off the edges of the tetrahedra by infinitesimals of different
//       orders, so that the arc never passes through a corner. docs/solid.md, section 9.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// The corners of a tetrahedron but the one that is the center.
using LinkTriangle = std::array<std::uint32_t, 3>;

/// Whether the arc from within one triangle of the link to within another one crosses that from p to q, all as directions from a point.
/// Requires: neither triangle is in a plane with the center, nor are p and q on a line with it.
bool arcs_cross(std::span<const Point3> points, std::uint32_t centre, const LinkTriangle& from, const LinkTriangle& to,
                std::uint32_t p, std::uint32_t q);

}  // namespace rbpa::space
