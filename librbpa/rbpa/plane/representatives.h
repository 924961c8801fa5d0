// What:   locates the pairs of persistence(): each hole as a polygon at its birth and just before its death, each
//         component by the edge at which it ends.
// Law:    a hole at a radius is the region that can be reached from its last triangle through triangles and edges that
//         appear later. Every curve of the complex around the hole encloses these triangles, so none encloses less
//         area. The result is a function of the set of points alone if no radii are equal; if several components end or
//         several holes are filled at equal radii, the order of the input decides how births and deaths are paired.
// Cost:   that of persistence(), and linear in the triangles of the chosen holes.
// Source: Obayashi, Volume-optimal cycle (2018); docs/explanation/filtration_and_persistence.md, section 5.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/pair_choice.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/persistence.h"

namespace rbpa {

/// A persistence pair with the edge or the polygons that locate it.
struct Representative {
  PersistencePair pair = {};
  /// Dimension 0: the ends, as ascending input indices, of the edge at which the component meets an older one; absent
  /// if pair.death is absent.
  std::optional<std::array<std::uint32_t, 2>> joined_at = std::nullopt;
  /// Dimension 1: the hole at pair.birth, and at the last radius at which the hole exists. At the last radius, the hole
  /// is one triangle, or several of equal circumradius; level_representatives() may return larger holes. Inner rings
  /// (Polygon::holes) surround the parts of the complex within the hole.
  Polygon at_birth = {}, before_death = {};
};

/// Returns representatives of the pairs of persistence() that `choice` chooses, in the same order.
/// Requires: `filtration` is filtration(delaunay), of which only the numbers of triangles and points are checked.
/// Throws:   ContractViolation when one of these numbers differs; Cancelled.
RBPA_API std::vector<Representative> representatives(const Delaunay& delaunay, const Filtration& filtration,
                                                     ComplexKind kind = ComplexKind::solid,
                                                     const PairChoice& choice = {}, const GoOn& go_on = {});

/// Returns representatives in the complexes of the given radii only, such as the levels of hrbpa(). A pair is born at
/// the first of these radii at which it exists, and dies at the first later radius at which it does not, if there is
/// one; `choice` and the order refer to this birth and death. A pair that exists at none of the radii is left out. The
/// polygons of a hole are taken at the first and the last of these radii at which the hole exists.
/// Requires: what representatives() requires; levels above 0, strictly ascending.
/// Throws:   ContractViolation as representatives(), or when the levels are not above 0 and strictly ascending;
///           Cancelled.
RBPA_API std::vector<Representative> level_representatives(const Delaunay& delaunay, const Filtration& filtration,
                                                           std::span<const double> levels,
                                                           ComplexKind kind = ComplexKind::solid,
                                                           const PairChoice& choice = {}, const GoOn& go_on = {});

}  // namespace rbpa
