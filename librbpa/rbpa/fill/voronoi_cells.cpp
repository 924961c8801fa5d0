#include "rbpa/fill/voronoi_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/fill/rings/polygon_rings.h"
#include "rbpa/fill/voronoi/cut_cells.h"
#include "rbpa/fill/voronoi/tidy_cells.h"

namespace rbpa {

VoronoiCells voronoi_cells(const Delaunay& delaunay, std::span<const Point> boundary_points,
                           std::span<const Polygon> boundary, const GoOn& go_on) {
  const std::vector<std::size_t> one_group = {0};
  PolygonRings rings = valid_polygons(boundary_points, boundary, one_group, go_on);
  for (std::size_t r = 0; r < rings.noded.rings.size(); ++r)
    if (rings.places[r].is_counter_clockwise == rings.places[r].is_hole())
      std::reverse(rings.noded.rings[r].points.begin(), rings.noded.rings[r].points.end());
  if (delaunay.points().empty()) return {};
  Steps step(go_on);
  return tidy(cut_cells(delaunay, boundary_points, rings.noded.rings, step), go_on);
}

CellBoundary box_around(std::span<const Point> points) {
  meshops::require(!points.empty(), "box_around: found no point, expected one or more");
  Point low = points[0], high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double margin = std::max(high.x / 10 - low.x / 10, high.y / 10 - low.y / 10);
  if (margin == 0) margin = std::max(std::abs(low.x), std::abs(low.y)) / 10;
  if (margin == 0) margin = 1;
  constexpr double largest = std::numeric_limits<double>::max();
  const auto below = [&](double x) { return std::max(std::min(x - margin, std::nextafter(x, -largest)), -largest); };
  const auto above = [&](double x) { return std::min(std::max(x + margin, std::nextafter(x, largest)), largest); };
  low = {below(low.x), below(low.y)};
  high = {above(high.x), above(high.y)};
  return {{low, {high.x, low.y}, high, {low.x, high.y}}, {{.shell = {{0, 1, 2, 3}}}}};
}

CellBoundary convex_hull(const Delaunay& delaunay) {
  const auto& [triangles, neighbors] = TriangleArrays(delaunay.triangulation());
  std::vector<std::uint32_t> next(delaunay.points().size(), no_index);
  std::uint32_t first = no_index;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (neighbors[t][k] == no_index) next[first = triangles[t][(k + 1) % 3]] = triangles[t][(k + 2) % 3];
  if (first == no_index) return {};
  CellBoundary hull = {.points = {}, .polygons = {Polygon{}}};
  std::uint32_t p = first;
  do {
    hull.polygons[0].shell.points.push_back(static_cast<std::uint32_t>(hull.points.size()));
    hull.points.push_back(delaunay.points()[p]);
    p = next[p];
  } while (p != first);
  return hull;
}

}  // namespace rbpa
