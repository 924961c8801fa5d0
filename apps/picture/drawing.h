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

/// A drawing of a complex or of polygons. Edges, curves and isolated points are lists of indices into `points`.
struct Drawing {
  std::span<const Point> points;
  std::vector<Edge> inner_edges;  ///< edges of two triangles; in each the lower index is first; sorted
  std::vector<std::vector<std::uint32_t>>
      curves;  ///< boundary curves of a complex, each from its least edge, sorted; or rings of polygons
  std::span<const std::uint32_t> isolated;
  std::span<const Edge> dangling = {};  ///< edges in no triangle
  /// The index of the first curve of each group, and at the end the number of curves. Empty: one color for all.
  std::vector<std::size_t> groups = {};
  std::span<const std::string> group_names = {};
};

/// Returns the drawing of a complex; it refers to `points` and `complex`. The isolated points are those in no triangle,
/// and in a full complex in no edge either. Requires: `points` are those of `complex`, and complex.neighbors is filled
/// in.
Drawing drawing_of(std::span<const Point> points, const AlphaComplex& complex, ComplexKind kind);

/// Returns the drawing of the rings of `polygons`, and of `isolated` points. It refers to `points` and `isolated`.
Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint32_t> isolated);

/// Returns the drawing of groups of polygons, each group in its color; it refers to `points` and `names`. Group g has
/// the polygons polygon_begin[g] to polygon_begin[g + 1] - 1.
Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint64_t> polygon_begin, std::span<const std::string> names);

}  // namespace rbpa::app
