// What:   for pairs of solid_persistence(), cells of the alpha complex that show where each is: the edge at which a component ends, a cycle of edges around a
//         tunnel, the triangles around a void with the tetrahedra in it.
// Law:    a tunnel's cycle is in the complex at its birth, has the edge that makes it, and becomes the boundary of triangles exactly when it ends. A void's triangles
//         bound its tetrahedra: all of it at its birth. Every surface that is homologous there has these tetrahedra within, so that none has less volume.
//         A function of the set of points alone where no radii and lengths are equal.
// Cost:   that of solid_persistence(); beside it, a search for a shortest path for each tunnel, and as much as it has tetrahedra for each void.
// Source: Obayashi, Volume-optimal cycle (2018): voids; Dijkstra (1959), Hart, Nilsson, Raphael (1968): shortest paths; docs/persistence_in_space.md.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/solid_filtration.h"
#include "rbpa/solid_persistence.h"

namespace rbpa {

struct SolidRepresentative {
  /// Dimension 0: the edge that ends it; none where there is no death. 1: edges of the cycle, one after the other, from the one that makes it on; if it has several
  /// loops, the others follow. 2: triangles around it, ascending.
  std::vector<std::uint32_t> cells;
  std::vector<std::uint32_t> tetrahedra;  ///< dimension 2: those in it, ascending
  std::vector<Triangle>
      faces;          ///< dimension 2: corners of its triangles, in their order, counter-clockwise seen from around
  double length = 0;  ///< of the edges
  double area = 0, volume = 0;  ///< of the triangles, and of the tetrahedra
  bool is_shortest = false;     ///< dimension 1: it is known that no cycle of which the law is true is shorter
};

/// One for each pair. Where a cycle is not known to be the shortest, shortest paths between its points, half of it apart, a quarter, an eighth and so on, were tried
/// in place of its own; it is never longer than that of the reduction.
/// Requires: these points' filtration, and pairs of it. Throws: ContractViolation where they visibly are not; Cancelled as solid_persistence().
RBPA_API std::vector<SolidRepresentative> solid_representatives(std::span<const Point3> points,
                                                                const SolidFiltration& filtration,
                                                                std::span<const SolidPair> pairs,
                                                                const std::function<bool()>& go_on = {});

}  // namespace rbpa
