// What:   the constrained Delaunay triangulation of polygons, with the points of the polygons as its only corners.
// Law:    the triangles cover the polygons once. Across every edge that is on no ring, the apex beyond lies outside of
//         the circumcircle. Of points on one circle the lexicographically largest is lifted
//         (docs/explanation/exact_decisions.md), so the triangulation is unique: it depends on the polygons as point
//         sets alone. All decisions are exact.
// How:    computes the Delaunay triangulation of the points, then inserts the missing edges one by one, in a random
//         order. For each edge, the triangles that it crosses are removed, a scan along its rim triangulates each of
//         the two cavities, and flips make the result constrained Delaunay again.
// Cost:   n log n, and for an edge that crosses m triangles m log m and flips: about m in practice, m² at worst. The
//         random order keeps the sum of all m small. The seed of the generator is fixed, so the order never varies.
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
/// Requires: distinct places, at most as many as rbpa() accepts, each on a ring; rings that do not cross, and that have
///           every place on their edges as a corner.
/// Throws:   Cancelled.
std::vector<std::array<std::uint32_t, 3>> constrained_delaunay(const Outline& outline, const GoOn& go_on);

}  // namespace rbpa
