// What:   computes the Delaunay triangulation of points: divides the points into halves, and merges the triangulations
//         of the halves. Does the work of a finder (tile/finder.h) where nothing lies beyond the tile.
// Law:    the triangles are those of the symbolic perturbation (docs/explanation/exact_decisions.md), a function of the
//         set of points alone; the time bound holds for every point set.
// Cost:   O(n log n) in the worst case; about n log log n comparisons of circles for points scattered evenly. 76 bytes
//         a point besides places and result.
// Source: Guibas, Stolfi (1985), figure 23; Dwyer (1987), for halves that are not long and narrow.
//         docs/explanation/plane.md, section 14.
#pragma once

#include <functional>
#include <span>

#include "meshops/patch/outline.h"
#include "meshops/patch/patch.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/divide/halve.h"

namespace rbpa {

/// A function that returns 0 if the triangle of three points is kept; otherwise Patch::open or Patch::nothing, which
/// the patch then stores in `across` of the triangle's neighbors. Several threads call the function at the same time.
/// An empty function keeps all triangles.
using Fate = std::function<int(const SitePoint&, const SitePoint&, const SitePoint&)>;

/// Returns the kept triangles, counter-clockwise, with sites for corners; Patch::nothing is across the sides of the
/// hull. There is no triangle if all points are on a line. Reorders `places`. Replaces `outline`, unless null, by the
/// outline of the patch. Calls working(), if any, repeatedly, in any thread, one call at a time; working() may throw.
/// Requires: distinct points, at most as many as rbpa() accepts, that the predicates of `Real` can decide: double if
///           the points fit (fits_double()), long double for any points.
template <typename Real>
meshops::Patch divide_and_conquer(
    std::span<SitePoint> places, const Fate& fate, Threads& threads, const Checkpoint& working = [] {},
    meshops::Outline* outline = nullptr);

}  // namespace rbpa
