#include "rbpa/space/persistence/pairing/pairing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/radii/sorted_by_alpha.h"
#include "rbpa/base/run/side_by_side.h"

namespace rbpa::space {
namespace {

/// Returns the pairs of points and edges. Requires: `order` has all edges of `filtration`, sorted by alpha.
PersistentComponents find_components(const SolidFiltration& filtration, std::span<const std::uint32_t> order,
                                     Steps& step) {
  // Elements of the sets are ranks of points, so that the least element is the first point of a component.
  const auto points = sorted_by_alpha(filtration.point_alpha, step);
  std::vector<std::uint32_t> rank(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) rank[points[i]] = i;
  const auto rank_of = [&](std::uint32_t point) { return rank.empty() ? point : rank[point]; };
  const auto point_at = [&](std::uint32_t i) { return points.empty() ? i : points[i]; };
  meshops::DisjointSets sets(rank.empty() ? corner_bound<2>(filtration.edges) : rank.size());
  PersistentComponents result;
  result.first = point_at(0);
  result.joins.assign(order.size(), false);
  for (const std::uint32_t edge : order) {
    step(4);
    const std::uint32_t a = sets.find(rank_of(filtration.edges[edge][0]));
    const std::uint32_t b = sets.find(rank_of(filtration.edges[edge][1]));
    if (a == b) continue;
    result.joins[edge] = true;
    result.all.push_back({point_at(std::max(a, b)), edge});
    sets.link(a, b);
  }
  return result;
}

}  // namespace

void check_filtration(const char* function, const SolidFiltration& filtration) {
  const auto& [simplices, neighbors, duplicates, isolated, distinct] = filtration.delaunay;
  const std::size_t triangles = filtration.triangles.size(), edges = filtration.edges.size();
  const auto require = [&](bool fits) {
    if (!fits) meshops::require(false, (std::string(function) + ": expected what solid_filtration() returned").c_str());
  };
  require(neighbors.size() == simplices.size() && filtration.triangles_of.size() == simplices.size() &&
          filtration.tetrahedron_alpha.size() == simplices.size() && filtration.triangle_alpha.size() == triangles &&
          filtration.edges_of.size() == triangles && filtration.edge_alpha.size() == edges);
  for (std::size_t t = 0; t < simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      require(filtration.triangles_of[t][k] < triangles &&
              (neighbors[t][k] == Solid::none || neighbors[t][k] < simplices.size()));
  for (const auto& of : filtration.edges_of)
    for (const std::uint32_t edge : of) require(edge < edges);
  for (const auto* values :
       {&filtration.tetrahedron_alpha, &filtration.triangle_alpha, &filtration.edge_alpha, &filtration.point_alpha})
    require(std::none_of(values->begin(), values->end(), [](double alpha) { return std::isnan(alpha); }));
  require(filtration.point_alpha.empty() || corner_bound<2>(filtration.edges) <= filtration.point_alpha.size());
}

void check_filtration(const char* function, std::span<const Point3> points, const SolidFiltration& filtration) {
  check_filtration(function, filtration);
  if (corner_bound<2>(filtration.edges) > points.size())
    meshops::require(false, (std::string(function) + ": expected the points of the filtration").c_str());
}

OuterPairing::OuterPairing(const SolidFiltration& filtration, Threads& threads, const GoOn& go_on) {
  side_by_side(
      threads, go_on,
      [&](Steps& step, const GoOn&) {
        voids = find_voids(filtration.delaunay, filtration.tetrahedron_alpha, filtration.triangles_of,
                           filtration.triangle_alpha, step);
      },
      [&](Steps& step, const GoOn&) {
        edges = sorted_by_alpha(filtration.edge_alpha, step);
        components = find_components(filtration, edges, step);
      });
}

}  // namespace rbpa::space
