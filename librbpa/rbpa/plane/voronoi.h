// What: the Voronoi diagram of points in the plane as arrays, with the names of scipy.spatial.Voronoi.
// Law:  the diagram is exactly the dual of the Delaunay triangulation; it does not depend on the order of the points,
//       up to numbering. A vertex is the real point, each coordinate rounded once.
// Note: voronoi_cells.h (rbpa/fill/) has the cells as polygons within a boundary.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/delaunay.h"

namespace rbpa {

/// A ridge with an end at infinity.
struct UnboundedRidge {
  std::size_t ridge = 0;  ///< its number
  /// The direction to the end at infinity, of length 1 within rounding. A whole bisector has the direction that has the
  /// first of its two points on the left.
  Point direction = {};
};

/// A Voronoi diagram. Equal points have one cell. Ridges are the common boundaries of two cells, longer than a point.
struct Voronoi {
  /// The index of a vertex that stands for infinity.
  static constexpr std::int32_t infinity = -1;

  /// The points at which three or more cells meet, each once; infinite beyond the range of double. Different vertices
  /// may be equal when rounded.
  std::vector<Point> vertices;
  /// For each ridge the two input points whose cells it separates, the smaller index first, in lexicographic order.
  std::vector<std::array<std::uint32_t, 2>> ridge_points;
  /// For each ridge its ends: vertices, infinity first. The whole bisector, of points on one line, has infinity twice.
  std::vector<std::array<std::int32_t, 2>> ridge_vertices;
  /// The ridges that have an end at infinity, in order.
  std::vector<UnboundedRidge> unbounded;
  /// The vertices of the cells, cell after cell in the order of the distinct points by index, each counter-clockwise;
  /// an unbounded cell has infinity once, between its last vertex and its first.
  std::vector<std::int32_t> region_vertices;
  std::vector<std::size_t> region_begin = {0};  ///< for each region its begin in region_vertices; then the end of all
  std::vector<std::uint32_t> point_region;      ///< for each input point its region, for equal points the same

  std::size_t regions() const { return region_begin.size() - 1; }  ///< the number of regions
  /// Returns the vertices of a region. Requires: `r` is less than regions(); not checked.
  std::span<const std::int32_t> region(std::size_t r) const {
    return std::span(region_vertices).subspan(region_begin[r], region_begin[r + 1] - region_begin[r]);
  }
};

/// Returns the Voronoi diagram of the points of `delaunay`.
/// Throws: Cancelled.
/// Cost:   linear, with 80 bytes a point for the time of the call; n log n if the points are on one line.
RBPA_API Voronoi voronoi(const Delaunay& delaunay, const GoOn& go_on = {});

}  // namespace rbpa
