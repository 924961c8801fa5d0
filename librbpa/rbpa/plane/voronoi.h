// What: the Voronoi diagram of points in the plane as arrays, with the names of scipy.spatial.Voronoi.
// Law:  the diagram is exactly the dual of the Delaunay triangulation; it does not depend on the order of the points,
//       up to numbering. A vertex is the real point, each coordinate rounded once.
// Note: voronoi_cells.h (rbpa/fill/) has the cells as polygons within a boundary.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/delaunay.h"

namespace rbpa {

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
  /// For each ridge with an end at infinity the direction to that end, of length 1 within rounding; otherwise (0, 0).
  /// A whole bisector has the direction that has the first of its two points on the left.
  std::vector<Point> ridge_directions;
  /// For each distinct point, by index, the vertices of its cell counter-clockwise; an unbounded cell has infinity
  /// once, between its last vertex and its first.
  std::vector<std::vector<std::int32_t>> regions;
  std::vector<std::uint32_t> point_region;  ///< for each input point its region, for equal points the same
};

/// Returns the Voronoi diagram of the points of `delaunay`.
/// Throws: Cancelled.
/// Cost:   linear; n log n if the points are on one line.
RBPA_API Voronoi voronoi(const Delaunay& delaunay, const GoOn& go_on = {});

}  // namespace rbpa
