// What:   computes the topology of the full alpha complex of points in space, and the voids of the complex as a solid.
// Law:    exact, for any finite input; a function of the set of points and alpha.
// How:    a void is a bounded component of the space outside of all tetrahedra and triangles of the complex. It
//         consists of Delaunay tetrahedra, connected through triangles that are not in the complex.
// Cost:   about linear in the Delaunay triangulation; microseconds a simplex where points are cospherical.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994); Delfinado and Edelsbrunner, An incremental
//         algorithm for Betti numbers of simplicial complexes on the 3-sphere (1995); docs/explanation/space.md,
//         section 21.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/voids.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// Counts of the full alpha complex. Each distinct point is in the complex.
struct FullCounts {
  std::size_t points = 0, edges = 0, triangles = 0, tetrahedra = 0;  ///< numbers of simplices in the complex
  std::size_t components = 0, tunnels = 0, voids = 0;                ///< Betti numbers 0 to 2
};

/// Counts the simplices and the Betti numbers of the full alpha complex.
/// Requires: `delaunay` is solid() of these points at infinity, with neighbors; `radii` are its circumradii(); 0 <
///           alpha ≤ infinity.
/// Throws:   as dangling_faces(); Cancelled, but never for points in a plane.
RBPA_API FullCounts count_full(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                               double alpha, MaxThreads threads = 0, const GoOn& go_on = {});

/// Returns the voids as a solid: the tetrahedra of the triangulation that are not in the complex and are not connected
/// to the outside through triangles that are not in the complex. Each of the solid_components() through triangles is a
/// void. The solid_boundary() has the walls, counter-clockwise seen from outside of the voids; a triangle of the
/// complex between two voids, or inside of one, occurs twice. Solid::isolated has the distinct points at no void.
/// Requires: as count_full().
/// Throws:   as count_full().
RBPA_API Solid void_space(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                          double alpha, MaxThreads threads = 0, const GoOn& go_on = {});

/// The voids of the full alpha complex, and the walls of all voids.
struct FullVoids {
  /// The walls, counter-clockwise seen from within a void: opposite to solid_boundary() of void_space(). A triangle
  /// between two voids, or inside of one, occurs twice.
  Surface boundary;
  std::vector<SolidVoid> all;  ///< the largest volume first; triangle numbers refer to `boundary`
};

/// Returns the measures and the walls of each void, including SolidVoid::outside_balls. SolidVoid::islands is the
/// number of pieces of the walls, connected through points, that do not surround the void.
/// Requires: `space` is the void_space() of these points at this alpha.
/// Throws:   ContractViolation when `space` is visibly of other points; Cancelled.
RBPA_API FullVoids full_voids(std::span<const Point3> points, const Solid& space, double alpha, MaxThreads threads = 0,
                              const GoOn& go_on = {});

struct FullTopology {
  FullCounts counts;
  FullVoids voids;
};

/// Returns the result of count_full(), and that of full_voids() for the void_space().
/// Requires: as count_full().
/// Throws:   as count_full().
RBPA_API FullTopology full_topology(std::span<const Point3> points, const Solid& delaunay,
                                    std::span<const double> radii, double alpha, MaxThreads threads = 0,
                                    const GoOn& go_on = {});

}  // namespace rbpa
