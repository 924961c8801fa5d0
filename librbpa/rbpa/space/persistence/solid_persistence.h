// What:   computes births and deaths of components, tunnels and voids of the full alpha complex in space as alpha
//         grows.
// Law:    the numbers of pairs with birth ≤ alpha < death in dimensions 0, 1 and 2 are the Betti numbers of the full
//         alpha complex at alpha. No pair has birth = death. The pairs are exact, with coefficients in Z/2: simplices
//         are ordered by alpha, dimension and number. Births and deaths are functions of the set of points; which
//         simplices of equal radii make a pair depends on their numbers.
// Cost:   union–find for dimensions 0 and 2; for dimension 1 a reduction that is nearly linear in practice.
// Source: Edelsbrunner, Letscher, Zomorodian, Topological persistence and simplification (2002); Delfinado,
//         Edelsbrunner (1995): dimension 2 by duality; Chen, Kerber, Persistent homology computation with a twist
//         (2011); docs/explanation/filtration_and_persistence.md, section 10.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// A component, tunnel or void that exists for birth ≤ alpha < death. A point creates a component, and an edge destroys
/// it. An edge creates a tunnel, and a triangle destroys it. A triangle creates a void, and a tetrahedron destroys it.
struct SolidPair {
  int dimension = 0;            ///< 0: component, 1: tunnel, 2: void
  double birth = 0;             ///< alpha, in units of the points
  std::optional<double> death;  ///< alpha; no value for the one component that never ends
  std::uint32_t born_by = 0;    ///< the simplex that creates: an input index, or an index in edges or triangles
  /// The simplex that destroys: an index in edges, triangles or delaunay.simplices; none if there is no death.
  std::uint32_t ended_by = Solid::none;
  friend bool operator==(const SolidPair&, const SolidPair&) = default;
};

/// Returns the pairs, sorted by dimension, birth, death (none is last), creating simplex and destroying simplex.
/// Requires: `filtration` is the result of solid_filtration() or of weighted_filtration(); the values of the latter
///           take the place of alpha.
/// Calls `beside`, unless it is empty, once from any thread, while another one reduces the matrix of dimension 1.
/// Throws:   ContractViolation when sizes or numbers in the arrays of the filtration do not fit together; Cancelled;
///           what `beside` throws.
RBPA_API std::vector<SolidPair> solid_persistence(const SolidFiltration& filtration, const GoOn& go_on = {},
                                                  MaxThreads threads = 0,
                                                  const std::function<void(const GoOn&)>& beside = {});

}  // namespace rbpa
