#include "rbpa/space/persistence/pairing/component_pairs.h"

#include <algorithm>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/radii/sorted_by_alpha.h"

namespace rbpa::space {

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

}  // namespace rbpa::space
