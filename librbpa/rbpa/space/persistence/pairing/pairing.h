// What: pairs each simplex that begins a homology class with the simplex that ends the class, in all dimensions.
// How:  each point begins a component. Edges join components in the order of the filtration. The later of two joined
//       components ends: the one whose point has the greater alpha or, at equal alpha, the greater number (Kruskal,
//       1956). Tunnels and voids have sources of their own.
// Cost: docs/explanation/filtration_and_persistence.md, section 10.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/tunnel_pairs.h"
#include "rbpa/space/persistence/pairing/void_pairs.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

/// Throws ContractViolation, with a message that begins with `function`, if sizes or numbers in the arrays of the
/// filtration do not fit together.
void check_filtration(const char* function, const SolidFiltration& filtration);
/// Throws ContractViolation if the filtration does not fit together, or an end of an edge is not an index of `points`.
void check_filtration(const char* function, std::span<const Point3> points, const SolidFiltration& filtration);

struct EndedComponent {
  std::uint32_t point, edge;  ///< numbers of the point that begins the component, and of the edge that ends it
};

struct PersistentComponents {
  std::vector<EndedComponent> all;  ///< the ended components, in the order of the filtration
  std::uint32_t first = 0;          ///< the first point, whose component never ends
  std::vector<bool> joins;          ///< for each edge: whether it ends a component; any other edge makes a tunnel
};

/// The pairs of components and of voids, which do not depend on each other.
struct OuterPairing {
  /// Throws Cancelled.
  OuterPairing(const SolidFiltration& filtration, Threads& threads, const GoOn& go_on);

  meshops::FreshVector<std::uint32_t> edges;  ///< numbers of all edges, sorted by alpha
  PersistentComponents components;
  PersistentVoids voids;
};

/// All pairs of a filtration. Requires: the filtration passes check_filtration().
struct Pairing : OuterPairing {
  Pairing(const SolidFiltration& filtration, Threads& threads, const GoOn& go_on, Steps& step)
      : OuterPairing(filtration, threads, go_on), tunnels(filtration, edges, components.joins, voids.makes_one, step) {}

  Tunnels tunnels;
};

}  // namespace rbpa::space
