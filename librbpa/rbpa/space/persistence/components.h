// What: which edge ends each component, and the point that made it.
// How:  each point is one from the beginning; edges join them in the order of the filtration, and where two components meet that of the greater point ends.
// Cost: union–find over the edges.
// Source: Kruskal (1956).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/solid_filtration.h"

namespace rbpa::space {

struct EndedComponent {
  std::uint32_t point, edge;
};

struct PersistentComponents {
  std::vector<EndedComponent> all;  ///< in the order of the filtration
  std::vector<bool> joins;          ///< of each edge: it ends a component; the others make a tunnel
};

/// `order` has the edges by alpha.
PersistentComponents find_components(const SolidFiltration& filtration, std::span<const std::uint32_t> order,
                                     Steps& step);

}  // namespace rbpa::space
