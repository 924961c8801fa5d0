// What:   the Delaunay triangulation of points, by dividing them in two and merging the halves: a finder
//         (tile/finder.h) on a tile that has no ghosts, and beyond which there is nothing.
// Law:    the triangles are those of the symbolic perturbation (docs/predicates.md), a function of the set of points
//         alone; no point set is bad.
// Cost:   O(n log n) in the worst case; about n log log n comparisons of circles for points scattered evenly. 76 bytes a
//         point besides places and result.
// Source: Guibas, Stolfi (1985), figure 23; parts that stay round: Dwyer (1987). docs/remainder.md.
#pragma once

#include <functional>
#include <span>

#include "meshops/patch/outline.h"
#include "meshops/patch/patch.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/plane/divide/halve.h"

namespace rbpa {

/// The fate of a triangle: 0 when it is kept; else what the patch stores for the triangles beside it. Called in any thread,
/// several at a time. Without a function all are kept.
using Fate = std::function<int(const SitePoint&, const SitePoint&, const SitePoint&)>;

/// The triangles that are kept, counter-clockwise and on the sites; on the hull `nothing` lies across. No triangle when
/// all points are on a line. Puts the places in another order. `outline`, if given, becomes that of the patch.
/// Calls working() now and then, in any thread and one at a time; it may throw to end it.
/// Requires: distinct points, no more than rbpa() accepts, whose predicates `Real` can decide: double where they fit
///           (fits_double()), long double wherever they are.
template <typename Real>
meshops::Patch divide_and_conquer(
    std::span<SitePoint> places, const Fate& fate, Threads& threads, const std::function<void()>& working = [] {},
    meshops::Outline* outline = nullptr);

}  // namespace rbpa
