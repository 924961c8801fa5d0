#include "triangulation/counts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/interrupt.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/boundary_curves.h"

namespace rbpa::app {
namespace {

/// One more than the largest index in a triangle or an edge.
std::size_t index_bound(const Triangulation& complex) {
  std::size_t bound = 0;
  for (const auto& corners : complex.triangles)
    bound = std::max<std::size_t>(bound, std::max({corners[0], corners[1], corners[2]}) + std::size_t{1});
  for (const auto& edge : complex.edges) bound = std::max(bound, edge[1] + std::size_t{1});
  return bound;
}

/// Triangles connected through edges.
std::size_t count_solid_components(const Triangulation& complex) {
  meshops::DisjointSets sets(complex.triangles.size());
  std::size_t components = complex.triangles.size();
  for (std::uint32_t t = 0; t < complex.triangles.size(); ++t) {
    if (t % 16384 == 0) stop_if_interrupted();
    for (const std::uint32_t other : complex.neighbors[t])
      if (other != Triangulation::none && other < t && sets.join(t, other)) --components;
  }
  return components;
}

/// How often an edge joins two points that were not connected before.
std::size_t count_joins(const Triangulation& complex) {
  meshops::DisjointSets sets(index_bound(complex));
  std::size_t joins = 0;
  for (std::size_t t = 0; t < complex.triangles.size(); ++t) {
    if (t % 16384 == 0) stop_if_interrupted();
    const auto& [a, b, c] = complex.triangles[t];
    joins += std::size_t{sets.join(a, b)} + std::size_t{sets.join(b, c)};
  }
  for (const auto& [a, b] : complex.edges) joins += std::size_t{sets.join(a, b)};
  return joins;
}

std::size_t count_edges(const Triangulation& complex) {
  std::size_t sides_of_two = 0;
  for (const auto& neighbors : complex.neighbors)
    sides_of_two += static_cast<std::size_t>(
        std::count_if(neighbors.begin(), neighbors.end(), [](std::uint32_t n) { return n != Triangulation::none; }));
  return 3 * complex.triangles.size() - sides_of_two / 2 + complex.edges.size();
}

}  // namespace

ComplexCounts count(const Triangulation& complex, Complex kind) {
  const std::size_t outside = kind == Complex::full ? complex.points.size() : complex.isolated.size();
  ComplexCounts counts{.points_covered = complex.distinct - outside,
                       .edges = count_edges(complex),
                       .triangles = complex.triangles.size(),
                       .boundary_curves = boundary_curves(complex, until_interrupted()).size(),
                       .solid_components = count_solid_components(complex)};
  const std::size_t points = kind == Complex::full ? complex.distinct : counts.points_covered;
  counts.components = points - count_joins(complex);
  counts.holes = counts.components + counts.edges - points - counts.triangles;
  return counts;
}

}  // namespace rbpa::app
