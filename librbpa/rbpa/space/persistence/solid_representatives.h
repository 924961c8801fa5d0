// What:   locates the pairs of solid_persistence() by the edge that ends a component, a cycle of edges around a tunnel,
//         or the triangles around a void and the tetrahedra in the void.
// Law:    a tunnel's cycle is in the complex at its birth, contains the edge that creates the tunnel, and becomes a
//         boundary of triangles exactly when the tunnel ends. A void's triangles bound the tetrahedra that fill the
//         void at its birth. Every homologous surface in the complex encloses these tetrahedra, and thus no less
//         volume. The result is a function of the set of points alone if no radii and no lengths are equal.
// Cost:   that of solid_persistence(), a shortest path for each tunnel, and a sort of the tetrahedra of each void.
// Source: Obayashi, Volume-optimal cycle (2018): voids; Dijkstra (1959), Hart, Nilsson, Raphael (1968): shortest paths;
//         docs/explanation/filtration_and_persistence.md, section 12.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"

namespace rbpa {

/// The location of one pair. Numbers are indices of simplices in the filtration.
struct SolidRepresentative {
  /// Dimension 0: the edge that ends the component; empty if the component never ends. Dimension 1: the edges in the
  /// order of the cycle, beginning with the edge that creates the tunnel. If the cycle has several loops, the edges of
  /// the other loops follow. Dimension 2: the triangles around the void, ascending.
  std::vector<std::uint32_t> cells;
  std::vector<std::uint32_t> tetrahedra;  ///< dimension 2: the tetrahedra in the void, ascending
  /// Dimension 2: the corners of each triangle in `cells`, in this order, counter-clockwise seen from outside the void.
  std::vector<Triangle> faces;
  double length = 0;            ///< dimensions 0 and 1: sum of the lengths of the edges, in units of the points
  double area = 0, volume = 0;  ///< dimension 2: area of the triangles, volume of the tetrahedra, with rounding errors
  bool is_shortest = false;     ///< dimension 1: whether the cycle is known to be the shortest that obeys `Law` above
};

/// Returns a representative for each pair, in the order of `pairs`. A cycle that is not known to be the shortest is
/// shortened: shortest paths replace parts of a half, a quarter, an eighth and so on of the cycle. The result is never
/// longer than the cycle that the reduction gives.
/// Requires: `filtration` is solid_filtration() of `points`; `pairs` are some of its solid_persistence(), in any order.
/// Throws:   ContractViolation when `points`, `filtration` and `pairs` do not fit together; Cancelled.
RBPA_API std::vector<SolidRepresentative> solid_representatives(std::span<const Point3> points,
                                                                const SolidFiltration& filtration,
                                                                std::span<const SolidPair> pairs,
                                                                const GoOn& go_on = {});

}  // namespace rbpa
