#include "rbpa/fill/voronoi_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/fill/rings/polygon_rings.h"
#include "rbpa/fill/voronoi/cut_cells.h"

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

std::array<Point, 4> box_around(std::span<const Point> points) {
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
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

}  // namespace rbpa
