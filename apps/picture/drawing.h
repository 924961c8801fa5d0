// What: what a picture of a complex shows, in the coordinates of the input.
// Law:  a function of the complex alone: edges and curves are in an order that no method of computing can change.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/mesh/write_triangles.h"
#include "rbpa/base/point.h"
#include "rbpa/shape.h"
#include "rbpa/triangulate.h"

namespace rbpa::app {

/// All as indices into `points`.
struct Drawing {
  std::span<const Point> points;
  std::vector<Edge> inner_edges;                   ///< between two triangles; lower index first, sorted
  std::vector<std::vector<std::uint32_t>> curves;  ///< around the solid, each from its least edge, sorted; or rings
  std::span<const std::uint32_t> isolated;
  std::span<const Edge> dangling = {};  ///< in no triangle
  /// Where the curves of each group begin, and their end; of groups with names. Empty: there are none, and one colour.
  std::vector<std::size_t> groups = {};
  std::span<const std::string> group_names = {};
};

/// Requires: `points` are those of the complex, which has neighbours. What it returns looks into both. Of a full
/// complex the isolated are those in neither a triangle nor an edge.
Drawing drawing_of(std::span<const Point> points, const Triangulation& complex, Complex kind);

/// Polygons without inner edges, their rings as they are. What it returns looks into `points` and `isolated`.
Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint32_t> isolated);

/// The polygons of groups, each in a colour: those of group g are numbers polygon_begin[g] to [g + 1] - 1.
Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint64_t> polygon_begin, std::span<const std::string> names);

}  // namespace rbpa::app
