// What:   all places where a ball among points is free to roll about an edge: the exposed triangles, and how they are glued.
// Law:    each free arc of each edge once; a function of the set of points and the radius, in an order that depends on no thread. Nothing has to be found by way of
//         something else, so that nothing can be missed.
// Cost:   with m points within two radii of a point, about m/2 edges a point, most of which are found to have no free arc
//         after looking at a few points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/core/point3.h"
#include "rbpa/parallel/threads.h"

namespace rbpa::space {

using Site = std::uint32_t;  ///< a position among distinct points

/// The ball, rolling about the edge ab, leaves the exposed triangle (a, b, left) and comes to (b, a, touched), with nothing
/// between. a < b.
struct FreeArc {
  Site a, b, left, touched;
};

/// Calls found(number of arcs so far) now and then, one call at a time but in any thread; what it throws ends the run.
/// Requires: distinct finite points, a finite radius above 0.
std::vector<FreeArc> find_free_arcs(std::span<const Point3> points, double radius, Threads& threads,
                                    const std::function<void(std::size_t)>& found = {});

}  // namespace rbpa::space
