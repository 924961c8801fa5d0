// What:   computes the births and deaths of components and holes while alpha grows from 0 to infinity.
// Law:    the complex at alpha has as many components as there are pairs of dimension 0 with birth ≤ alpha < death, and
//         as many holes as there are pairs of dimension 1 with birth ≤ alpha < death. For the solid complex, the steps
//         of filtration() have these numbers. No pair has birth = death.
// Cost:   sorts the edges; the rest is near-linear.
// Source: Edelsbrunner, Letscher, Zomorodian, Topological persistence and simplification (2002): the elder rule;
//         Delfinado, Edelsbrunner, An incremental algorithm for Betti numbers (1995): holes by duality.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/complex_kind.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"

namespace rbpa {

/// A component (dimension 0) or a hole (dimension 1) that exists for birth ≤ alpha < death. When two components meet,
/// the younger one dies. Birth and death are radii, rounded up to doubles; a radius above all doubles is infinity.
struct PersistencePair {
  int dimension = 0;
  double birth = 0;
  std::optional<double> death;  ///< absent if the component or hole never ends
  friend bool operator==(const PersistencePair&, const PersistencePair&) = default;
};

/// Returns the pairs sorted by dimension, then birth, then death, pairs without a death last. The result is a function
/// of the set of points alone.
/// Requires: `filtration` is filtration(delaunay), of which only the numbers of triangles and points are checked.
/// Throws:   ContractViolation when one of these numbers differs; Cancelled.
RBPA_API std::vector<PersistencePair> persistence(const Delaunay& delaunay, const Filtration& filtration,
                                                  ComplexKind kind = ComplexKind::solid, const GoOn& go_on = {});
/// Returns the pairs of a triangulation that alpha_complex(points, infinity, {.neighbors = true}) returned.
/// Throws: as the first overload; ContractViolation as the constructor of Delaunay, which checks the triangulation.
inline std::vector<PersistencePair> persistence(const AlphaComplex& delaunay, std::span<const Point> points,
                                                const Filtration& filtration, ComplexKind kind = ComplexKind::solid,
                                                const GoOn& go_on = {}) {
  return persistence(Delaunay(delaunay, points, go_on, "persistence"), filtration, kind, go_on);
}

}  // namespace rbpa
