// What:   births and deaths of components and holes while alpha grows from 0 to infinity.
// Law:    components at alpha = pairs of dimension 0 with birth ≤ alpha < death; holes = those of dimension 1. For the
//         solid complex these are the numbers of the filtration's steps. A pair never has birth = death.
// Cost:   sorts the edges; the rest is near-linear.
// Source: Edelsbrunner, Letscher, Zomorodian, Topological persistence and simplification (2002): the elder rule;
//         Delfinado, Edelsbrunner, An incremental algorithm for Betti numbers (1995): holes by duality.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/delaunay.h"
#include "rbpa/filtration.h"
#include "rbpa/triangulate.h"

namespace rbpa {

enum class ComplexKind {
  solid,  ///< triangles of circumradius ≤ alpha, with their edges and vertices
  full    ///< the alpha complex: moreover every point from 0 on, and edges whose ends a ball of radius alpha can touch
          ///< with no point inside, triangle or not
};

/// A component (dimension 0) or a hole (dimension 1) that exists for birth ≤ alpha < death.
/// Of two components that meet the younger dies. Both are double radii, rounded up from the exact ones.
struct PersistencePair {
  int dimension = 0;
  double birth = 0;
  std::optional<double> death;  ///< absent: never
  friend bool operator==(const PersistencePair&, const PersistencePair&) = default;
};

/// Sorted by dimension, birth, death, those without a death last. A function of the set of points alone.
/// Requires: `filtration` is filtration(delaunay).
/// Throws:   ContractViolation when it is visibly of another triangulation; Cancelled when `go_on`, which is called every few
///           milliseconds, returns false. Empty: never called.
RBPA_API std::vector<PersistencePair> persistence(const Delaunay& delaunay, const Filtration& filtration,
                                                  ComplexKind kind = ComplexKind::solid,
                                                  const std::function<bool()>& go_on = {});
/// The same of triangulate(points, infinity, {.neighbors = true}), which is checked first, as by Delaunay.
inline std::vector<PersistencePair> persistence(const Triangulation& delaunay, std::span<const Point> points,
                                                const Filtration& filtration, ComplexKind kind = ComplexKind::solid,
                                                const std::function<bool()>& go_on = {}) {
  return persistence(Delaunay(delaunay, points, go_on, "persistence"), filtration, kind, go_on);
}

}  // namespace rbpa
