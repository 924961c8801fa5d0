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

/// A target length of edges at a point, in units of the points: edges near `at` get at most about the length `size`.
struct SizeAt {
  Point at;
  double size;
};

/// Options of fill().
struct FillOptions {
  /// Target length of edges, in units of the points; required, above 0. `grade` and `sizes` lower the target in places.
  /// With infinity, fill() adds no point, and the triangles are the constrained Delaunay triangulation of each group,
  /// which the tie-breaking of docs/explanation/exact_decisions.md makes unique; `grade` and `sizes` must then be
  /// absent.
  double size = 0;
  /// Growth of the target length per unit of distance from the middle of each boundary edge that is shorter than
  /// `size`. At the middle, the target is at most the length of the edge. A finite number above 0; if absent, short
  /// edges do not lower the target.
  std::optional<double> grade = std::nullopt;
  /// Target lengths at points: at p the target is the least of `size` and all sizes[i].size + g |p − sizes[i].at|,
  /// where g is `grade` or, if absent, default_grade. The target is thus the greatest function of slope at most g that
  /// exceeds no given value. Points and sizes are finite, sizes above 0.
  std::span<const SizeAt> sizes = {};
  /// Whether fill() adds no point on the boundary. If false, fill() cuts boundary edges that are longer than the
  /// target.
  bool keep_boundary = false;
  /// The index of the first polygon of each group, ascending from 0; a group is, for instance, a feature of a map. If
  /// empty, all polygons are one group. Groups may share edges, along which their triangles meet in whole edges. Groups
  /// may overlap; each group then has its own triangles.
  std::span<const std::size_t> groups = {};
  OnProgress progress = {};  ///< callback for progress and cancellation
  /// Callback that fill() calls once, before the first triangle, with an estimate of the number of triangles, so that a
  /// caller can compare the number with the available memory; docs/explanation/plane.md, section 28, states the
  /// accuracy. Not called if there is no polygon or the size is infinite. An exception of the callback ends the run.
  std::function<void(double)> estimated = {};

  static constexpr double default_grade = 0.25;
};

/// Result of fill().
struct Filling {
  /// All input points with their indices; then the points that fill() added on boundary edges; then the added inner
  /// points.
  std::vector<Point> points;
  /// Number of input points plus points added on boundary edges; inner points have indices from this number on.
  std::size_t boundary_points = 0;
  /// The triangles, counter-clockwise, the smallest index first, in lexicographic order.
  std::vector<Triangle> triangles;
  std::vector<std::size_t> groups;  ///< for each triangle, the group that it fills
  /// For each triangle, entry k is the triangle across from corner k, or TriangleArrays::none. Triangles of two groups
  /// are neighbors along edges that the groups share. But if triangles of two groups lie on one side of an edge, these
  /// groups overlap, and all triangles of either group have neighbors in their own group only.
  std::vector<Triangle> neighbors;
  /// The input polygons, with the points on boundary edges in the rings: shells counter-clockwise, holes clockwise,
  /// each ring from its lexicographically least input point on. Areas are exact sums, rounded once.
  std::vector<Polygon> polygons;
  /// Number of triangles that the front removed again, because no good triangle fitted beside them.
  std::size_t retreats = 0;
  /// Number of triangles of the unfilled region that the front created, flipped, or crossed in searches: a measure of
  /// its work.
  std::size_t passed = 0;

  operator TriangleArrays() const { return {triangles, neighbors}; }
};

}  // namespace rbpa
