#include "rbpa/plane/voronoi.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/predicate/constructions.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/voronoi/cell_ridges.h"

namespace rbpa {
namespace {

constexpr std::uint32_t ahead = 16;  // memory of a triangle is prefetched this many triangles before

std::vector<Point> centers_of(const Delaunay& delaunay, Steps& step) {
  const std::vector<Triangle>& triangles = delaunay.triangulation().triangles;
  const std::span<const Point> points = delaunay.points();
  std::vector<Point> centers;
  centers.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    step();
    if (t + ahead < triangles.size())
      for (const std::uint32_t corner : triangles[t + ahead]) __builtin_prefetch(&points[corner]);
    const auto& [a, b, c] = triangles[t];
    centers.push_back(circumcenter(points[a], points[b], points[c]));
  }
  return centers;
}

/// Returns the sets of triangles that have the same circle. Then the rounded centers are equal, too, so that few
/// triangles have to be tested.
meshops::DisjointSets cocircular_sets(const Delaunay& delaunay, std::span<const Point> centers, Steps& step) {
  const std::vector<Triangle>& triangles = delaunay.triangulation().triangles;
  const std::vector<Triangle>& neighbors = delaunay.triangulation().neighbors;
  const std::span<const Point> points = delaunay.points();
  meshops::DisjointSets sets(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    step();
    if (t + ahead < triangles.size())
      for (const std::uint32_t other : neighbors[t + ahead])
        if (other != no_index && other > t) __builtin_prefetch(&centers[other]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = neighbors[t][k];
      if (other == no_index || other < t || centers[other] != centers[t]) continue;
      const auto& [a, b, c] = triangles[t];
      const auto& [p, q, r] = triangles[other];
      const std::uint32_t apex = p ^ q ^ r ^ triangles[t][(k + 1) % 3] ^ triangles[t][(k + 2) % 3];  // not of the side
      if (Predicates<long double>::in_circle(points[a], points[b], points[c], points[apex]) == 0) sets.join(t, other);
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
  const std::vector<Point> centers = centers_of(delaunay, step);
  meshops::DisjointSets sets = cocircular_sets(delaunay, centers, step);
  std::vector<std::int32_t> vertex_of(made.triangles.size());
  for (std::uint32_t t = 0; t < made.triangles.size(); ++t) {
    step();
    const std::uint32_t least = sets.find(t);
    vertex_of[t] = least == t ? static_cast<std::int32_t>(result.vertices.size()) : vertex_of[least];
    if (least == t) result.vertices.push_back(centers[t]);
  }
  const auto vertex = [&](std::uint32_t t) { return t == no_index ? Voronoi::infinity : vertex_of[t]; };
  result.point_region.resize(delaunay.points().size());
  const TrianglesAt at(made.triangles, delaunay.points().size());
  std::vector<CellRidge> later;
  std::vector<std::int32_t> region;
  result.regions.reserve(made.distinct);
  result.ridge_points.reserve(3 * made.distinct);
  result.ridge_vertices.reserve(3 * made.distinct);
  result.ridge_directions.reserve(3 * made.distinct);
  for (std::uint32_t p = 0; p < result.point_region.size(); ++p) {
    if (const std::uint32_t next = p + ahead / 4; next < result.point_region.size())
      for (const std::uint32_t t : at[next]) {
        __builtin_prefetch(&made.triangles[t]);
        __builtin_prefetch(&made.neighbors[t]);
        __builtin_prefetch(&vertex_of[t]);
      }
    if (!ridges.has_cell(p)) continue;
    result.point_region[p] = static_cast<std::uint32_t>(result.regions.size());
    region.clear();
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
    result.regions.emplace_back(region.begin(), region.end());
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
