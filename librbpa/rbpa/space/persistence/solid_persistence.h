// What:   computes the births and deaths of components, tunnels and voids of the alpha complex in space while alpha
//         grows from 0 to infinity.
// Law:    the pairs with birth ≤ alpha < death are the components (dimension 0), tunnels (dimension 1) and voids
//         (dimension 2) at alpha: the Betti numbers of the full alpha complex. A pair never has birth = death. Exact,
//         with coefficients in Z/2: simplices are ordered by alpha, dimension and number. A function of the set of
//         points alone; of simplices of equal radii, which ones make a pair depends on their numbers.
// Cost:   union–find for dimensions 0 and 2; for dimension 1 a reduction that is nearly linear in practice.
// Source: Edelsbrunner, Letscher, Zomorodian, Topological persistence and simplification (2002); Delfinado,
//         Edelsbrunner (1995): dimension 2 by duality; Chen, Kerber, Persistent homology computation with a twist
//         (2011); docs/explanation/filtration_and_persistence.md, section 10.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// A component, tunnel or void that exists for birth ≤ alpha < death. A point creates a component, and an edge destroys
/// it; for a tunnel these are an edge and a triangle, for a void a triangle and a tetrahedron.
struct SolidPair {
  int dimension = 0;            ///< 0: component, 1: tunnel, 2: void
  double birth = 0;             ///< alpha, in units of the points
  std::optional<double> death;  ///< alpha; absent: never, as for one component
  std::uint32_t born_by = 0;    ///< the simplex that creates: an input index, or a number in edges or triangles
  /// The simplex that destroys: a number in edges, triangles or delaunay.simplices; none if there is no death.
  std::uint32_t ended_by = Solid::none;
  friend bool operator==(const SolidPair&, const SolidPair&) = default;
};

/// Returns the pairs, sorted by dimension, birth, death (without a death last), and by the simplex that creates them.
/// Requires: `filtration` is the result of solid_filtration(); or of weighted_filtration(), whose values then take the
///           place of alpha.
/// Throws:   ContractViolation when sizes or numbers in the arrays of the filtration do not fit together; Cancelled.
RBPA_API std::vector<SolidPair> solid_persistence(const SolidFiltration& filtration, const GoOn& go_on = {});

}  // namespace rbpa
