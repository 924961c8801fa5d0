// What:   computes the topology of a periodic alpha complex, solid or full: pieces and voids, each with volume, area
//         and the number of directions in which it percolates, and Betti numbers in the torus that the box forms.
// Law:    a function of the set of points, the box and alpha. Exact, except volumes and areas, which are sums rounded
//         once. The volumes of all pieces and voids together are that of the box, up to rounding. b₀ − b₁ + b₂ − b₃ =
//         points − edges + triangles − tetrahedra.
// How:    the Delaunay tetrahedra fill the box, so voids consist of the tetrahedra that are not in the complex; in the
//         full complex, its triangles separate voids as well. A piece or a void percolates in a direction if a path
//         through its tetrahedra leads from a tetrahedron to its image in that direction. docs/explanation/space.md,
//         section 23.
// Cost:   linear in the tetrahedra of the triangulation, and a sort of the edges at each point.
// Source: Delfinado and Edelsbrunner (1995); Alexander–Lefschetz duality.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/space/solid/periodic_solid.h"
#include "rbpa/space/solid/voids.h"

namespace rbpa {

/// A piece of the solid that is connected through triangles, or a void.
struct PeriodicPart {
  std::size_t tetrahedra = 0;
  std::vector<std::uint32_t> points;  ///< corners of the boundary triangles; ascending
  double volume = 0, area = 0;        ///< in one box, in cubed and squared units of the points
  /// For a void of the full complex, the volume of the part that is at least alpha from every input point: the possible
  /// centers of a ball of radius alpha.
  std::optional<double> outside_balls = {};
  /// Number of independent directions in which the part percolates. A void: 0 = closed, 1 = channel, 2 = layer, 3 =
  /// network.
  unsigned dimension = 0;
};

/// The topology of a complex. The full complex has all points, the solid one only the corners of its tetrahedra.
struct PeriodicTopology {
  std::size_t points = 0, edges = 0, triangles = 0, tetrahedra = 0;  ///< simplices of the complex in one box
  std::size_t boundary_triangles = 0;                                ///< triangles of exactly one tetrahedron
  std::array<std::size_t, 4> betti = {0, 0, 0, 0};                   ///< Betti numbers b₀ to b₃
  double volume = 0, area = 0;                                       ///< volume of the tetrahedra, area of the boundary
  std::vector<PeriodicPart> solid_components, voids;                 ///< the largest volume first
};

/// Computes the topology of the complex of kind `walls`: of the solid complex, or of the full one. No ball of radius
/// alpha can leave a void of the full complex.
/// Requires: `delaunay` is periodic_solid() at infinity, with neighbors; `radii` are the circumradii() of its positions
///           and simplices; 0 < alpha ≤ infinity.
/// Throws:   ContractViolation when sizes differ or a tetrahedron lacks a neighbor; InvalidInput when alpha is not
///           above 0; Cancelled. The rest is not checked.
RBPA_API PeriodicTopology periodic_topology(const PeriodicSolid& delaunay, std::span<const double> radii, double alpha,
                                            ComplexKind walls = ComplexKind::full, MaxThreads threads = 0,
                                            const GoOn& go_on = {});

}  // namespace rbpa
