// What: the options and the result of fill().
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// A target size at a point: edges near `at` are to be no longer than about `size`.
struct SizeAt {
  Point at;
  double size;
};

struct FillOptions {
  /// Target length of edges, in units of the points; an upper bound where the members below require less. Infinity: no
  /// point is added, and the triangles are the constrained Delaunay triangulation of the polygons
  /// (fill/constrained_delaunay.h), which is unique; `grade` and `sizes` must then be absent.
  double size = 0;
  /// Growth of the target per unit of distance from a boundary edge shorter than `size`, at which triangles have the
  /// edge's length. Absent: short edges do not change the size.
  std::optional<double> grade = std::nullopt;
  /// Sizes at points: at p the target is the least of `size` and sizes[i].size + g |p − sizes[i].at|, where g is
  /// `grade`, or default_grade. This is the greatest function of slope g that exceeds no given value.
  std::span<const SizeAt> sizes = {};
  /// Whether the boundary stays as it is. Otherwise edges that are longer than the target are cut.
  bool keep_boundary = false;
  /// The first polygon of each group, ascending from 0; a group is a feature of a map, for example. Empty: all polygons
  /// are one group. Groups may share edges, along which their triangles meet in whole edges. Groups may overlap: then
  /// each has triangles of its own.
  std::span<const std::size_t> groups = {};
  OnProgress progress = {};
  /// Called once, before the first triangle, with an estimate of their number, so that a caller can compare it with the
  /// available memory; fill/size_estimate.h states its accuracy. An exception that it throws ends the run. Empty: never
  /// called.
  std::function<void(double)> estimated = {};

  static constexpr double default_grade = 0.25;
};

struct Filling {
  /// The input points under their indices, whether used or not; then the points inserted on edges of the boundary; then
  /// those inside.
  std::vector<Point> points;
  /// Number of points that are of the input or on cut edges; they come first.
  std::size_t boundary_points = 0;
  /// The triangles, counter-clockwise, the smallest index first, in lexicographic order.
  std::vector<Triangle> triangles;
  std::vector<std::size_t> groups;  ///< for each triangle, the group that it fills
  /// The triangle across from each corner, or TriangleArrays::none. Groups are neighbors along the edges that they
  /// share. If two triangles have the same edge on their left, their groups overlap, and each group has neighbors in
  /// itself only.
  std::vector<Triangle> neighbors;
  /// The polygons with the points inserted on their edges; areas are exact sums, rounded once.
  std::vector<Polygon> polygons;
  /// Number of times the front had to retreat.
  std::size_t retreats = 0;
  /// Number of triangles of the unfilled region that were created or crossed in locating points: a measure of the
  /// front's work.
  std::size_t passed = 0;

  operator TriangleArrays() const { return {triangles, neighbors}; }
};

}  // namespace rbpa
