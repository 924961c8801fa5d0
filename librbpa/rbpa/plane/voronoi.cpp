#include "rbpa/plane/voronoi.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "meshops/core/fresh_vector.h"
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
  meshops::reserve_in_large_pages(centers, triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    step();
    if (t + ahead < triangles.size())
      for (const std::uint32_t corner : triangles[t + ahead]) __builtin_prefetch(&points[corner]);
    const auto& [a, b, c] = triangles[t];
    centers.push_back(circumcenter(points[a], points[b], points[c]));
  }
  return centers;
}

/// Returns the sets of triangles that have the same circle; no sets if no two have. Triangles that have the same circle
/// have the same rounded center, so that few have to be tested.
meshops::DisjointSets cocircular_sets(const Delaunay& delaunay, std::span<const Point> centers, Steps& step) {
  const std::vector<Triangle>& triangles = delaunay.triangulation().triangles;
  const std::vector<Triangle>& neighbors = delaunay.triangulation().neighbors;
  const std::span<const Point> points = delaunay.points();
  meshops::DisjointSets sets;
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
      if (Predicates<long double>::in_circle(points[a], points[b], points[c], points[apex]) != 0) continue;
      if (sets.size() == 0) sets = meshops::DisjointSets(triangles.size());
      sets.join(t, other);
    }
  }
  return sets;
}

/// Keeps one vertex for each set of triangles. Returns the vertex of each triangle.
meshops::FreshVector<std::int32_t> join_vertices(std::vector<Point>& vertices, meshops::DisjointSets& sets,
                                                 Steps& step) {
  meshops::FreshVector<std::int32_t> vertex_of(sets.size());
  std::int32_t kept = 0;
  for (std::uint32_t t = 0; t < sets.size(); ++t) {
    step();
    const std::uint32_t least = sets.find(t);
    vertex_of[t] = least == t ? kept : vertex_of[least];
    if (least == t) vertices[static_cast<std::size_t>(kept++)] = vertices[t];
  }
  vertices.resize(static_cast<std::size_t>(kept));
  return vertex_of;
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
  const CellRidges ridges(delaunay, step);
  const AlphaComplex& made = delaunay.triangulation();
  Voronoi result;
  result.vertices = centers_of(delaunay, step);
  meshops::FreshVector<std::int32_t> vertex_of;  // empty: the vertex of each triangle has its number
  if (auto sets = cocircular_sets(delaunay, result.vertices, step); sets.size() > 0)
    vertex_of = join_vertices(result.vertices, sets, step);
  const auto vertex = [&](std::uint32_t t) {
    return t == no_index ? Voronoi::infinity : vertex_of.empty() ? static_cast<std::int32_t>(t) : vertex_of[t];
  };
  result.point_region.resize(delaunay.points().size());
  std::vector<CellRidge> later;
  meshops::reserve_in_large_pages(result.region_begin, made.distinct + 1);
  meshops::reserve_in_large_pages(result.region_vertices, 6 * made.distinct);
  meshops::reserve_in_large_pages(result.ridge_points, 3 * made.distinct);
  meshops::reserve_in_large_pages(result.ridge_vertices, 3 * made.distinct);
  for (std::uint32_t p = 0; p < result.point_region.size(); ++p) {
    if (!ridges.has_cell(p)) continue;
    result.point_region[p] = static_cast<std::uint32_t>(result.regions());
    std::vector<std::int32_t>& region = result.region_vertices;
    const auto is_empty = [&] { return region.size() == result.region_begin.back(); };
    later.clear();
    ridges.for_each(p, [&](const CellRidge& ridge) {
      step();
      const std::int32_t from = vertex(ridge.from), to = vertex(ridge.to);
      const bool is_line = ridge.from == no_index && ridge.to == no_index;
      if (from == to && !is_line) return false;
      if (is_empty() || region.back() != Voronoi::infinity) region.push_back(to);
      if (ridge.other > p) later.push_back(ridge);
      return false;
    });
    if (is_empty()) region.push_back(Voronoi::infinity);
    result.region_begin.push_back(region.size());
    std::sort(later.begin(), later.end(), [](const CellRidge& a, const CellRidge& b) { return a.other < b.other; });
    for (const CellRidge& ridge : later) {
      const auto [low, high] = std::minmax({vertex(ridge.from), vertex(ridge.to)});
      if (low == Voronoi::infinity) {
        const bool is_end = ridge.to == no_index;  // otherwise the ridge comes from infinity
        result.unbounded.push_back({result.ridge_points.size(), right_normal(ridges.point(is_end ? ridge.other : p),
                                                                             ridges.point(is_end ? p : ridge.other))});
      }
      result.ridge_points.push_back({p, ridge.other});
      result.ridge_vertices.push_back({low, high});
    }
  }
  for (const auto& [index, stands_for] : made.duplicates) result.point_region[index] = result.point_region[stands_for];
  return result;
}

}  // namespace rbpa
