// What:   values at all points of a filling, such as heights, from those at the points that were given to fill().
// Law:    a given point keeps its value, to the last bit. A point that was put on an edge is between the ends of the edge by its
//         distance from them. A point inside has the value that is linear in the triangle that contains it, of the constrained
//         Delaunay triangulation of the boundary of its group; which triangle that is is decided exactly.
// Cost:   n log n in all points.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/fill.h"

namespace rbpa {

/// Requires: a filling of fill() with these groups (FillOptions::groups), and the value of each point that it was given.
/// Throws:   InvalidInput when there are more values than points; Cancelled when `go_on`, which is called every few milliseconds,
///           returns false. Empty: never called.
RBPA_API std::vector<double> values_on_filling(const Filling& filling, std::span<const double> values,
                                               std::span<const std::size_t> groups = {},
                                               const std::function<bool()>& go_on = {});

}  // namespace rbpa
