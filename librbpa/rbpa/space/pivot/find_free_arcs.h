// What:   all places where a ball among points is free to roll about an edge: the exposed triangles, and how they are glued.
// Law:    each free arc of each edge once; a function of the set of points and the radius. Nothing has to be found by way of
//         something else, so that nothing can be missed.
// Cost:   with m points within two radii of a point, about m/2 edges a point, most of which are found to have no free arc
//         after looking at a few points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/core/point3.h"

namespace rbpa::space {

using Site = std::uint32_t;  ///< a position among distinct points

/// The ball, rolling about the edge ab, leaves the exposed triangle (a, b, left) and comes to (b, a, touched), with nothing
/// between. a < b.
struct FreeArc {
  Site a, b, left, touched;
};

/// Requires: distinct finite points, a finite radius above 0.
std::vector<FreeArc> find_free_arcs(std::span<const Point3> points, double radius);

}  // namespace rbpa::space
