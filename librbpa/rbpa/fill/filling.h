// What: the options and the result of fill(), which triangulates polygons.
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

/// A target length of edges at a point, in units of the points: edges near `at` are to be no longer than about `size`.
struct SizeAt {
  Point at;
  double size;
};

/// Options of fill().
struct FillOptions {
  /// Target length of edges, in units of the points; must be given, above 0. `grade` and `sizes` lower the target in
  /// places. Infinity: no point is added, and the triangles are the constrained Delaunay triangulation of each group,
  /// which the tie-breaking of docs/explanation/exact_decisions.md makes unique; `grade` and `sizes` must then be
  /// absent.
  double size = 0;
  /// Growth of the target length per unit of distance from the middle of a boundary edge that is shorter than `size`;
  /// there the target is the length of the edge. A finite number above 0. Absent: short edges do not lower the target.
  std::optional<double> grade = std::nullopt;
  /// Sizes at points: at p the target is the least of `size` and sizes[i].size + g |p − sizes[i].at|, where g is
  /// `grade`, or default_grade. The target is thus the greatest function of slope g that exceeds no given value. Points
  /// and sizes are finite, sizes above 0.
  std::span<const SizeAt> sizes = {};
  /// Whether the boundary stays as it is. Otherwise boundary edges that are longer than the target are cut.
  bool keep_boundary = false;
  /// The index of the first polygon of each group, ascending from 0; a group is a feature of a map, say. Empty: all
  /// polygons are one group. Groups may share edges, along which their triangles meet in whole edges. Groups may
  /// overlap: then each has triangles of its own.
  std::span<const std::size_t> groups = {};
  OnProgress progress = {};  ///< callback for progress and cancellation
  /// Callback that is called once, before the first triangle, with an estimate of the number of triangles, so that a
  /// caller can compare the number with the available memory; docs/explanation/plane.md, section 28, states the
  /// accuracy. Not called without a polygon or with an infinite size. An exception of the callback ends the run.
  std::function<void(double)> estimated = {};

  static constexpr double default_grade = 0.25;
};

/// Result of fill().
struct Filling {
  /// The input points under their indices, whether used or not; then the points inserted on edges of the boundary; then
  /// those inside.
  std::vector<Point> points;
  /// Number of input points and points inserted on edges of the boundary: the first in `points`.
  std::size_t boundary_points = 0;
  /// The triangles, counter-clockwise, the smallest index first, in lexicographic order.
  std::vector<Triangle> triangles;
  std::vector<std::size_t> groups;  ///< for each triangle, the group that it fills
  /// For each triangle, entry k is the triangle across from its corner k, or TriangleArrays::none. Triangles of two
  /// groups are neighbors along edges that the groups share; but where the groups overlap, so that two triangles have
  /// the same edge on their left, each group has neighbors in itself only.
  std::vector<Triangle> neighbors;
  /// The input polygons with all boundary points in their rings: shells counter-clockwise, holes clockwise, each ring
  /// from its lexicographically least input point on. Areas are exact sums, rounded once.
  std::vector<Polygon> polygons;
  /// Number of times that the front removed a triangle again, because no good triangle fitted beside that triangle.
  std::size_t retreats = 0;
  /// Number of triangles of the unfilled region that were created or crossed in locating points: a measure of the
  /// front's work.
  std::size_t passed = 0;

  operator TriangleArrays() const { return {triangles, neighbors}; }
};

}  // namespace rbpa
