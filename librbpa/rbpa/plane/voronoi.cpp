#include "rbpa/plane/voronoi.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/predicate/constructions.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/voronoi/cell_ridges.h"

namespace rbpa {
namespace {

/// Returns the sets of triangles that have the same circle.
meshops::DisjointSets cocircular_sets(const Delaunay& delaunay, Steps& step) {
  const auto& [triangles, neighbors] = TriangleArrays(delaunay.triangulation());
  const std::span<const Point> points = delaunay.points();
  meshops::DisjointSets sets(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    step();
    const Triangle& corners = triangles[t];
    for (const std::uint32_t other : neighbors[t]) {
      if (other == no_index || other < t) continue;
      const Triangle& beyond = triangles[other];
      const std::uint32_t apex = *std::find_if(beyond.begin(), beyond.end(), [&](std::uint32_t p) {
        return std::find(corners.begin(), corners.end(), p) == corners.end();
      });
      if (Predicates<long double>::in_circle(points[corners[0]], points[corners[1]], points[corners[2]],
                                             points[apex]) == 0)
        sets.join(t, other);
    }
  }
  return sets;
}

/// Returns the direction of q − p turned to the right.
Point right_normal(const Point& p, const Point& q) {
  const double share = std::isfinite(q.x - p.x) && std::isfinite(q.y - p.y) ? 1 : 0.5;
  const double dx = q.x * share - p.x * share, dy = q.y * share - p.y * share;
  const int exponent = -std::ilogb(std::max(std::abs(dx), std::abs(dy)));
  const double x = std::scalbn(dx, exponent), y = std::scalbn(dy, exponent), length = std::sqrt(x * x + y * y);
  return {y / length + 0.0, -x / length + 0.0};
}

}  // namespace

Voronoi voronoi(const Delaunay& delaunay, const GoOn& go_on) {
  Steps step(go_on);
  const CellRidges ridges(delaunay);
  const AlphaComplex& made = delaunay.triangulation();
  Voronoi result;
  meshops::DisjointSets sets = cocircular_sets(delaunay, step);
  std::vector<std::int32_t> vertex_of(made.triangles.size());
  for (std::uint32_t t = 0; t < made.triangles.size(); ++t) {
    step();
    const std::uint32_t least = sets.find(t);
    if (least == t) {
      const auto& [a, b, c] = made.triangles[t];
      result.vertices.push_back(circumcenter(ridges.point(a), ridges.point(b), ridges.point(c)));
    }
    vertex_of[t] = least == t ? static_cast<std::int32_t>(result.vertices.size()) - 1 : vertex_of[least];
  }
  const auto vertex = [&](std::uint32_t t) { return t == no_index ? Voronoi::infinity : vertex_of[t]; };
  result.point_region.resize(delaunay.points().size());
  std::vector<CellRidge> later;
  for (std::uint32_t p = 0; p < result.point_region.size(); ++p) {
    if (!ridges.has_cell(p)) continue;
    result.point_region[p] = static_cast<std::uint32_t>(result.regions.size());
    std::vector<std::int32_t>& region = result.regions.emplace_back();
    later.clear();
    ridges.for_each(p, [&](const CellRidge& ridge) {
      step();
      const std::int32_t from = vertex(ridge.from), to = vertex(ridge.to);
      const bool is_line = ridge.from == no_index && ridge.to == no_index;
      if (from == to && !is_line) return false;
      if (region.empty() || region.back() != Voronoi::infinity) region.push_back(to);
      if (ridge.other > p) later.push_back(ridge);
      return false;
    });
    if (region.empty()) region.push_back(Voronoi::infinity);
    std::sort(later.begin(), later.end(), [](const CellRidge& a, const CellRidge& b) { return a.other < b.other; });
    for (const CellRidge& ridge : later) {
      result.ridge_points.push_back({p, ridge.other});
      const auto [low, high] = std::minmax({vertex(ridge.from), vertex(ridge.to)});
      result.ridge_vertices.push_back({low, high});
      Point direction;
      if (ridge.to == no_index)
        direction = right_normal(ridges.point(ridge.other), ridges.point(p));
      else if (ridge.from == no_index)
        direction = right_normal(ridges.point(p), ridges.point(ridge.other));
      result.ridge_directions.push_back(direction);
    }
  }
  for (const auto& [index, stands_for] : made.duplicates) result.point_region[index] = result.point_region[stands_for];
  return result;
}

}  // namespace rbpa
