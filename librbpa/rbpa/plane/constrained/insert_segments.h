// What:   inserts segments into a Delaunay triangulation, which becomes the constrained one.
// Law:    that of constrained_delaunay.h. All decisions are exact.
// How:    segments are inserted in a random order. For each one, the triangles that it crosses are removed, a scan
//         along the rim triangulates each of the two cavities, and flips make the result constrained Delaunay again. A
//         segment that passes through points is inserted from point to point.
// Cost:   for a segment that crosses m triangles m log m and flips: about m in practice, m² at worst. The random order
//         keeps the sum of all m small. The seed of the generator is fixed, so the order never varies.
// Source: Lawson, Software for C1 surface interpolation (1977); Chew, Constrained Delaunay triangulations (1989);
//         Anglada, An improved incremental algorithm for constructing restricted Delaunay triangulations (1997);
//         Toussaint, Avis, On a convex hull algorithm for polygons and its application to triangulation problems
//         (1982), for the scan.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/plane/constrained_delaunay.h"

namespace rbpa {

/// Triangles with their neighbors. fixed[t] has the bits of ConstrainedDelaunay::constrained, and the bit `changed` if
/// the triangle is not one of the given ones.
struct FixedTriangles {
  static constexpr std::uint8_t changed = 8;
  std::vector<Triangle> triangles, neighbors;
  std::vector<std::uint8_t> fixed;
};

/// A segment, by its number, and a part of another segment that crosses it.
struct SegmentCrossing {
  std::size_t segment;
  Segment part;
};

/// Inserts the segments. Returns a crossing of two of them, if any; the triangles are then in an unspecified state.
/// Requires: the Delaunay triangulation of the points, which are not all on one line, with `fixed` all 0; segments
///           between different places, whose ends are corners of triangles.
/// Throws:   Cancelled.
std::optional<SegmentCrossing> insert_segments(std::span<const Point> points, std::span<const Segment> segments,
                                               FixedTriangles& of, Steps& step);

}  // namespace rbpa
