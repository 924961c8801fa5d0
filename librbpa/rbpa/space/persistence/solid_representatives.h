// What:   locates the pairs of solid_persistence(): the edge at which a component ends, a cycle of edges around a
//         tunnel, the triangles around a void with the tetrahedra in it.
// Law:    a tunnel's cycle is in the complex at its birth, contains the edge that creates the tunnel, and becomes a
//         boundary of triangles exactly when the tunnel ends. A void's triangles bound the tetrahedra that fill the
//         void at its birth. Every homologous surface in the complex then encloses these tetrahedra, so none encloses
//         less volume. The result is a function of the set of points alone if no radii and no lengths are equal.
// Cost:   that of solid_persistence(); also a search for a shortest path for each tunnel, and linear time in the
//         tetrahedra of each void.
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

/// The place of one pair. Numbers are those of simplices of the filtration.
struct SolidRepresentative {
  /// Dimension 0: the edge that ends the component; empty if the component never ends. Dimension 1: the edges of the
  /// cycle, one after the other, beginning with the edge that creates the tunnel; if the cycle has several loops, the
  /// edges of each other loop follow. Dimension 2: the triangles around the void, ascending.
  std::vector<std::uint32_t> cells;
  std::vector<std::uint32_t> tetrahedra;  ///< dimension 2: the tetrahedra in the void, ascending
  /// Dimension 2: the corners of the triangles in `cells`, in this order, counter-clockwise seen from outside the void.
  std::vector<Triangle> faces;
  double length = 0;            ///< dimensions 0 and 1: sum of the lengths of the edges, in units of the points
  double area = 0, volume = 0;  ///< dimension 2: area of the triangles, volume of the tetrahedra, with rounding errors
  bool is_shortest = false;     ///< dimension 1: whether the cycle is known to be the shortest that obeys the law above
};

/// Returns a representative for each pair, in the order of `pairs`. A cycle that is not known to be the shortest was
/// shortened: shortest paths between points of the cycle that are half of the cycle apart, a quarter, an eighth and so
/// on replace parts. A cycle is never longer than the cycle that the reduction gives.
/// Requires: `filtration` is solid_filtration() of `points`; `pairs` are some of its solid_persistence(), in any order.
/// Throws:   ContractViolation when numbers in the points, filtration and pairs do not fit together; Cancelled.
RBPA_API std::vector<SolidRepresentative> solid_representatives(std::span<const Point3> points,
                                                                const SolidFiltration& filtration,
                                                                std::span<const SolidPair> pairs,
                                                                const GoOn& go_on = {});

}  // namespace rbpa
