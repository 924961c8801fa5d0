#include "rbpa/space/persistence/pairing/component_pairs.h"

#include <algorithm>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/simplices_at.h"

namespace rbpa::space {

PersistentComponents find_components(const SolidFiltration& filtration, std::span<const std::uint32_t> order,
                                     Steps& step) {
  meshops::DisjointSets sets(corner_bound<2>(filtration.edges));
  PersistentComponents result;
  result.joins.assign(order.size(), false);
  for (const std::uint32_t edge : order) {
    step(4);
    const std::uint32_t a = sets.find(filtration.edges[edge][0]), b = sets.find(filtration.edges[edge][1]);
    if (a == b) continue;
    result.joins[edge] = true;
    result.all.push_back({std::max(a, b), edge});
    sets.link(a, b);
  }
  return result;
}

}  // namespace rbpa::space
