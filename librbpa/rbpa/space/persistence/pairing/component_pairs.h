// What: finds for each component the point that begins the component and the edge that ends it.
// How:  each point begins a component. Edges join components in the order of the filtration. The later of two joined
//       components ends: the one whose point has the greater alpha or, at equal alpha, the greater number.
// Cost: union–find over the edges.
// Source: Kruskal (1956).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

struct EndedComponent {
  std::uint32_t point, edge;  ///< numbers of the point that begins the component, and of the edge that ends it
};

struct PersistentComponents {
  std::vector<EndedComponent> all;  ///< the ended components, in the order of the filtration
  std::uint32_t first = 0;          ///< the first point, whose component never ends
  std::vector<bool> joins;          ///< for each edge: whether it ends a component; any other edge makes a tunnel
};

/// Returns the pairs of points and edges. Requires: `order` has all edges of `filtration`, sorted by alpha.
PersistentComponents find_components(const SolidFiltration& filtration, std::span<const std::uint32_t> order,
                                     Steps& step);

}  // namespace rbpa::space
