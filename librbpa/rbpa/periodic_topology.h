// What:   the topology of a solid that repeats: its pieces and voids with volume, area and the number of directions in which they go on for ever,
//         and its Betti numbers as a part of the torus that the box is.
// Law:    exact in all but volumes and areas, and these are sums rounded once; a function of the set of points, the box and alpha. The volumes of pieces and
//         voids add up to that of the box. b₀ − b₁ + b₂ − b₃ = points − edges + triangles − tetrahedra.
// How:    all tetrahedra fill the box, so that voids are the tetrahedra that are left out. A way through tetrahedra that ends in an image of where it began
//         is a direction in which a piece or a void goes on. docs/solid.md, section 13.
// Cost:   linear in the tetrahedra of the triangulation, and a sort of the edges at each point.
// Source: Delfinado and Edelsbrunner (1995); Alexander–Lefschetz duality.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/periodic_solid.h"

namespace rbpa {

/// A piece of the solid that is connected through triangles, or a void.
struct PeriodicPart {
  std::size_t tetrahedra = 0;
  std::vector<std::uint32_t> points;  ///< corners of the triangles that bound it; ascending
  double volume = 0, area = 0;        ///< in one box
  /// In how many independent directions it reaches images of itself: of a void, 0 = closed, 1 = a channel, 2 = a layer, 3 = a network.
  unsigned dimension = 0;
};

struct PeriodicTopology {
  std::size_t points = 0, edges = 0, triangles = 0, tetrahedra = 0;  ///< of the solid in one box
  std::size_t boundary_triangles = 0;
  std::array<std::size_t, 4> betti = {0, 0, 0, 0};
  double volume = 0, area = 0;
  std::vector<PeriodicPart> solid_components, voids;  ///< the largest volume first
};

/// Of the tetrahedra of radius at most alpha.
/// Requires: periodic_solid() at infinity with neighbors, and its circumradii. Throws ContractViolation on others.
RBPA_API PeriodicTopology periodic_topology(const PeriodicSolid& delaunay, std::span<const double> radii, double alpha);

}  // namespace rbpa
