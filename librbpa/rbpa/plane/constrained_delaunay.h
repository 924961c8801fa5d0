// What:   the constrained Delaunay triangulation of points and segments, such as a terrain with breaklines.
// Law:    every segment is an edge, or a chain of edges from point to point. Across every other edge, the apex beyond
//         lies outside of the circumcircle; of points on one circle the lexicographically largest is lifted
//         (docs/explanation/exact_decisions.md). So the triangulation is unique, and depends on points and segments as
//         point sets alone, up to numbering. All decisions are exact.
// Cost:   that of alpha_complex(); for a segment that crosses m triangles about m, at worst m². Splitting crossings
//         takes n log n in the segments and the pairs of boxes that meet, two or three times as a rule.
// Source: Chew, Constrained Delaunay triangulations (1989); Anglada, An improved incremental algorithm for constructing
//         restricted Delaunay triangulations (1997).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// The two ends of a segment, as indices of points.
using Segment = std::array<std::uint32_t, 2>;

struct ConstrainedDelaunayOptions {
  /// Whether segments that cross are split where they cross: at an end of one of them that is within a few units in the
  /// last place of the other, or else at the crossing, rounded to doubles. Segments bend by that; if they then cross
  /// others, these are split as well.
  bool split_crossings = false;
  MaxThreads threads = 0;    ///< maximum number for the Delaunay triangulation; 0: all processors
  OnProgress progress = {};  ///< callback for progress and cancellation
};

/// A triangulation of the convex hull of its points. If these are on one line, there are edges alone.
struct ConstrainedDelaunay {
  /// All input points with their indices; then, in lexicographic order, the points at which segments were split.
  std::vector<Point> points;
  /// For each of these added points two of the segments that cross there, as indices, the smaller first.
  std::vector<std::array<std::uint32_t, 2>> crossed;
  /// The triangles, counter-clockwise, the smallest index first, in lexicographic order.
  std::vector<Triangle> triangles;
  /// For each triangle, entry k is the number of the triangle across from its corner k, or TriangleArrays::none.
  std::vector<Triangle> neighbors;
  /// For each triangle a set of bits: bit k is 1 if the side across from its corner k is on a segment, and bit 4 + k if
  /// it is on an odd number of segments.
  std::vector<std::uint8_t> constrained;
  /// The edges on segments, the smaller index first, in lexicographic order.
  std::vector<Segment> edges;
  /// The sides of the convex hull, each with its triangle on the left, in lexicographic order.
  std::vector<Segment> boundary;
  std::vector<Duplicate> duplicates;  ///< ascending by index

  bool is_constrained(std::uint32_t triangle, std::uint32_t k) const { return (constrained[triangle] >> k & 1) != 0; }
  operator TriangleArrays() const { return {triangles, neighbors, true}; }
};

/// Returns the constrained Delaunay triangulation. Points on a segment split it; segments may overlap and repeat. Of
/// equal points the one of lowest index is used.
/// Throws: InvalidInput as alpha_complex() does; when an end of a segment is no point, or both ends are at one place;
///         when two segments cross at a place that is no point, unless options.split_crossings; when 100 rounds of
///         splitting do not suffice. Cancelled.
RBPA_API ConstrainedDelaunay constrained_delaunay(std::span<const Point> points, std::span<const Segment> segments,
                                                  const ConstrainedDelaunayOptions& options = {});

/// The regions into which segments divide a triangulation.
struct SegmentRegions {
  /// For each triangle the number of its region; regions are numbered in the order of their first triangles.
  std::vector<std::uint32_t> region;
  /// For each region, whether it is inside by the even-odd rule: whether a path from outside crosses an odd number of
  /// segments. Overlapping segments count each. If all segments are sides of closed curves, every path gives the same
  /// answer; otherwise only paths that cross the fewest edges count.
  std::vector<bool> is_inside;
};

/// Returns the regions.
/// Requires: a result of constrained_delaunay(); not checked.
/// Throws:   Cancelled.
/// Cost:     linear.
RBPA_API SegmentRegions regions(const ConstrainedDelaunay& triangulation, const GoOn& go_on = {});

}  // namespace rbpa
