// What: the content of a picture of a complex, in the coordinates of the input.
// Law:  a function of the complex alone: the order of edges and curves does not depend on the method of computing it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/mesh/write_triangles.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa::app {

/// A drawing of a complex or of polygons. Edges, curves and isolated points are indices into `points`.
struct Drawing {
  std::span<const Point> points;
  std::vector<Edge> inner_edges;  ///< edges between two triangles; lower index first, sorted
  std::vector<std::vector<std::uint32_t>>
      curves;  ///< boundary curves of the solid, each from its least edge, sorted; or the rings of polygons
  std::span<const std::uint32_t> isolated;
  std::span<const Edge> dangling = {};  ///< edges in no triangle
  /// For named groups, the first curve of each group, and the end of the last. Empty: no groups, and one color.
  std::vector<std::size_t> groups = {};
  std::span<const std::string> group_names = {};
};

/// Returns the drawing of a complex. It refers to both arguments. In a full complex, isolated points are those in
/// neither a triangle nor an edge. Requires: `points` are those of the complex, and it has neighbors.
Drawing drawing_of(std::span<const Point> points, const AlphaComplex& complex, ComplexKind kind);

/// Returns the drawing of polygons: their rings, without inner edges. It refers to `points` and `isolated`.
Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint32_t> isolated);

/// Returns the drawing of groups of polygons, each in its color. Group g has the polygons polygon_begin[g] to
/// polygon_begin[g + 1] - 1.
Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint64_t> polygon_begin, std::span<const std::string> names);

}  // namespace rbpa::app
