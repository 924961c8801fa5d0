// What: interpolates values such as heights at all points of a filling from the values at the points given to fill().
// Law:  a given point keeps its value, to the last bit. The value of a point inserted on an edge is interpolated
//       linearly between the given points on both sides along the edge. The value of an inner point is interpolated
//       linearly in the triangle that contains the point in the constrained Delaunay triangulation of its group's
//       boundary; an exact test finds this triangle.
// Cost: n log n in all points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/fill/filling.h"

namespace rbpa {

/// Returns a value for each point of the filling.
/// Requires: `filling` is the result of fill() with `groups` as FillOptions::groups; `values` has a value for each
///           point that was given to fill(). Not checked: with fewer values, results may be NaN.
/// Throws:   InvalidInput when there are more values than filling.boundary_points; Cancelled.
RBPA_API std::vector<double> values_on_filling(const Filling& filling, std::span<const double> values,
                                               std::span<const std::size_t> groups = {}, const GoOn& go_on = {});

}  // namespace rbpa
