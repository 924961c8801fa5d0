// What: defines the content of a picture of a complex, in the coordinates of the input.
// Law:  a drawing depends on the complex alone; the order of edges and curves does not depend on the method.
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

/// A drawing of a complex or of polygons. Edges, curves and isolated points are given by indices into `points`.
struct Drawing {
  std::span<const Point> points;
  std::vector<Edge> inner_edges;  ///< edges of two triangles, sorted; the lower index of each edge is first
  std::vector<std::vector<std::uint32_t>>
      curves;  ///< boundary curves of a complex, each from its least edge, sorted; or rings of polygons
  std::span<const std::uint32_t> isolated;
  std::span<const Edge> dangling = {};  ///< edges in no triangle
  /// The index of the first curve of each group, and at the end the number of curves. Empty: all curves have one color.
  std::vector<std::size_t> groups = {};
  std::span<const std::string> group_names = {};
};

/// Returns the drawing of a complex, which refers to `points` and `complex`. The isolated points are the points in no
/// triangle, and for the full complex in no edge either. Requires: `points` are the points of `complex`;
/// complex.neighbors is set.
Drawing drawing_of(std::span<const Point> points, const AlphaComplex& complex, ComplexKind kind);

/// Returns the drawing of the rings of `polygons` and of `isolated` points; it refers to `points` and `isolated`.
Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint32_t> isolated);

/// Returns the drawing of groups of polygons, each group in its own color. The drawing refers to `points` and `names`.
/// Group g has the polygons polygon_begin[g] to polygon_begin[g + 1] - 1.
Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint64_t> polygon_begin, std::span<const std::string> names);

}  // namespace rbpa::app
