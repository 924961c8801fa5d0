// What:   where the pairs of persistence() are: each hole as a polygon at its birth, and as what is left of it just before its death; each component by the edge at
//         which it ends.
// Law:    a hole at a radius is all that can be reached from its last triangle through triangles and edges that come later: everything that encloses it there
//         has these triangles within, so that none has less area. A function of the set of points alone, but for the edges where radii are equal.
// Cost:   that of persistence(); beside it, linear in the triangles of the holes that are chosen.
// Source: Obayashi, Volume-optimal cycle (2018); docs/filtration.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/delaunay.h"
#include "rbpa/filtration.h"
#include "rbpa/pair_choice.h"
#include "rbpa/persistence.h"
#include "rbpa/shape.h"

namespace rbpa {

struct Representative {
  PersistencePair pair = {};
  /// Dimension 0: input indices of the points at whose edge it meets an older component; absent where it never ends.
  std::optional<std::array<std::uint32_t, 2>> joined_at = std::nullopt;
  /// Dimension 1: the hole at `birth`, and at the last radius at which it is there: a triangle then, or several of one circle, but for those of levels.
  /// Rings inside are around what is in it.
  Polygon at_birth = {}, before_death = {};
};

/// Of the pairs that are chosen, sorted as persistence() sorts them.
/// Requires: `filtration` is filtration(delaunay).
/// Throws:   ContractViolation when it is visibly of another triangulation; Cancelled when `go_on`, which is called every few
///           milliseconds, returns false. Empty: never called.
RBPA_API std::vector<Representative> representatives(const Delaunay& delaunay, const Filtration& filtration,
                                                     ComplexKind kind = ComplexKind::solid,
                                                     const PairChoice& choice = {},
                                                     const std::function<bool()>& go_on = {});

/// The same of the complexes of some radii alone, as hrbpa() has them. A pair is born at the first of them at which something is there, and ends at the first at which
/// it is no more, if there is one; what is at none of them is left out. A hole is a polygon at the first and at the last of them at which it is there.
/// Requires: radii above 0, ascending, none twice. Throws: moreover ContractViolation on others.
RBPA_API std::vector<Representative> level_representatives(const Delaunay& delaunay, const Filtration& filtration,
                                                           std::span<const double> levels,
                                                           ComplexKind kind = ComplexKind::solid,
                                                           const PairChoice& choice = {},
                                                           const std::function<bool()>& go_on = {});

}  // namespace rbpa
