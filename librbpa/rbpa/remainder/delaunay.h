// What:   the Delaunay triangulation of points, by dividing them in two and merging what each half gives.
// Law:    the triangles are those of the symbolic perturbation (docs/predicates.md), a function of the set of points
//         alone; no point set is bad.
// Cost:   O(n log n) in the worst case; about n log log n comparisons of circles for points scattered evenly. 110 bytes
//         a point besides the result.
// Source: Guibas, Stolfi (1985), figure 23; cuts across and along in turn: Dwyer (1987). docs/remainder.md.
#pragma once

#include <functional>
#include <span>

#include "meshops/front/patch.h"
#include "rbpa/core/point.h"

namespace rbpa {

/// Every triangle, counter-clockwise, its corners as positions in `points`, and what lies across each side: `open` on
/// the hull. Nothing when all points are on a line. Replaces `patch`.
/// Calls working() now and then, which may throw to end it.
/// Requires: distinct points that fit double (fits_double()), fewer than 2²⁹.
void delaunay(
    std::span<const Point> points, meshops::Patch& patch, const std::function<void()>& working = [] {});

}  // namespace rbpa
