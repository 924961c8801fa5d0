// What: pairs each simplex that begins a homology class with the simplex that ends the class, in all dimensions.
// Cost: docs/explanation/filtration_and_persistence.md, section 10.
#pragma once

#include <cstdint>
#include <span>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/component_pairs.h"
#include "rbpa/space/persistence/pairing/sorted_by_alpha.h"
#include "rbpa/space/persistence/pairing/tunnel_pairs.h"
#include "rbpa/space/persistence/pairing/void_pairs.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

/// Throws ContractViolation, with a message that begins with `function`, if sizes or numbers in the arrays of the
/// filtration do not fit together.
void check_filtration(const char* function, const SolidFiltration& filtration);
/// Throws ContractViolation if the filtration does not fit together, or an end of an edge is not an index of `points`.
void check_filtration(const char* function, std::span<const Point3> points, const SolidFiltration& filtration);

/// All pairs of a filtration. Requires: the filtration passes check_filtration().
struct Pairing {
  Pairing(const SolidFiltration& filtration, Steps& step)
      : edges(sorted_by_alpha(filtration.edge_alpha, step)),
        components(find_components(filtration, edges, step)),
        voids(find_voids(filtration.delaunay, filtration.tetrahedron_alpha, filtration.triangles_of,
                         filtration.triangle_alpha, step)),
        tunnels(filtration, edges, components.joins, voids.makes_one, step) {}

  meshops::FreshVector<std::uint32_t> edges;  ///< numbers of all edges, sorted by alpha
  PersistentComponents components;
  PersistentVoids voids;
  Tunnels tunnels;
};

}  // namespace rbpa::space
