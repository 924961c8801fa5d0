// What:   locates the pairs of persistence(): each hole as a polygon at its birth and just before its death, each
//         component by the edge at which it ends.
// Law:    a hole at a radius is the region that can be reached from its last triangle through triangles and edges that
//         appear later. Every curve of the complex around the hole encloses these triangles, so none encloses less
//         area. The result is a function of the set of points alone, except for the edges if radii are equal.
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
  /// Dimension 0: the ends, as input indices, of the edge at which the component meets an older one; absent if the
  /// component never dies.
  std::optional<std::array<std::uint32_t, 2>> joined_at = std::nullopt;
  /// Dimension 1: the hole at pair.birth, and at the last radius at which the hole exists. There the hole is one
  /// triangle, or several with the same circumcircle; level_representatives() may return larger holes. Inner rings
  /// (Polygon::holes) surround the parts of the complex within the hole.
  Polygon at_birth = {}, before_death = {};
};

/// Returns representatives of the chosen pairs, sorted as by persistence().
/// Requires: `filtration` is filtration(delaunay).
/// Throws:   ContractViolation when `filtration` is visibly of another triangulation; Cancelled.
RBPA_API std::vector<Representative> representatives(const Delaunay& delaunay, const Filtration& filtration,
                                                     ComplexKind kind = ComplexKind::solid,
                                                     const PairChoice& choice = {}, const GoOn& go_on = {});

/// Returns representatives in the complexes of the given radii only, such as the levels of hrbpa(). A pair is born at
/// the first of these radii at which it exists, and dies at the first later radius at which it does not, if there is
/// one; a pair that exists at none of the radii is left out. The polygons of a hole are taken at the first and the last
/// of these radii at which the hole exists.
/// Requires: what representatives() requires; radii above 0, ascending, none twice.
/// Throws:   ContractViolation if the radii are not positive and strictly ascending, or the filtration is visibly of
///           another triangulation; Cancelled.
RBPA_API std::vector<Representative> level_representatives(const Delaunay& delaunay, const Filtration& filtration,
                                                           std::span<const double> levels,
                                                           ComplexKind kind = ComplexKind::solid,
                                                           const PairChoice& choice = {}, const GoOn& go_on = {});

}  // namespace rbpa
