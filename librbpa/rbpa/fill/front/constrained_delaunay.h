// What:   the constrained Delaunay triangulation of polygons, with their own points as corners and no others.
// Law:    the triangles cover the polygons once. Across every edge that is on no ring, the apex beyond lies outside of
//         the circle. Of points on one circle the lexicographically largest is lifted, as everywhere
//         (docs/explanation/exact_decisions.md), so there is one such triangulation: a function of the polygons as a
//         set. All decisions are exact.
// How:    the Delaunay triangulation of the points; then the edges that it lacks, one after the other in a random
//         order. The triangles that an edge crosses are removed, a scan along its rim triangulates each of the two
//         cavities, and flips make the result Delaunay again.
// Cost:   n log n, and for an edge that crosses m triangles m log m and flips: about m in practice, m² at worst. The
//         random order keeps the sum of all m small; it is the same every time, as the generator has a fixed seed.
// Source: Lawson, Software for C1 surface interpolation (1977); Chew, Constrained Delaunay triangulations (1989);
//         Anglada, An improved incremental algorithm for constructing restricted Delaunay triangulations (1997);
//         Toussaint, Avis, On a convex hull algorithm for polygons and its application to triangulation problems
//         (1982), for the scan.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/fill/front/outline.h"

namespace rbpa {

/// Returns the constrained Delaunay triangles of `outline`, counter-clockwise, in no particular order; corners are
/// positions in `outline.places`. Several rings may pass through a place, and two rings may pass through an edge in
/// opposite directions.
/// Requires: places that are distinct, as many as rbpa() accepts, and each on a ring; rings that do not cross, and pass
///           every place that lies on their edges.
/// Throws:   Cancelled.
std::vector<std::array<std::uint32_t, 3>> constrained_delaunay(const Outline& outline, const GoOn& go_on);

}  // namespace rbpa
