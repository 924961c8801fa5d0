// What:   computes the regular triangulation (weighted Delaunay triangulation) of balls in space, as arrays of indices
//         in canonical order, and lists the balls that have no cell in the power diagram.
// How:    ball i lifts its center c to height |c|² − R²; the triangulation is the lower hull of the lifted centers.
// Law:    a function of the set of balls, not of any order or thread. Every decision is exact, on any finite input: the
//         weight of a ball is the exact square of its radius. Ties are decided by the symbolic perturbation of CGAL, so
//         CGAL's Regular_triangulation_3 has the same tetrahedra and hides the same balls. With equal radii, the
//         tetrahedra are those of solid() at infinity. docs/explanation/exact_decisions.md, section 8.
// Cost:   that of a Delaunay triangulation by insertion, and a third more. Time, and the number of tetrahedra, are
//         quadratic in the worst case.
// Source: Edelsbrunner and Shah, Incremental topological flipping works for regular triangulations (1996); Devillers
//         and Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations (2011).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// Tetrahedra of balls, with their neighbors. Corners are input indices; the lowest index among equal balls stands for
/// all of them.
struct RegularTriangulation {
  /// The value for no neighbor in `neighbors`, and for no corner in `flat`.
  static constexpr std::uint32_t none = Solid::none;

  /// The tetrahedra and their neighbors in the form of Solid. Empty if all centers are in one plane.
  std::vector<std::array<std::uint32_t, 4>> simplices, neighbors;
  /// The regular triangulation within the plane, line or point that contains all centers. Rows are triangles (a, b, c,
  /// none) in a plane, edges (a, b, none, none) between neighbors on a line, or one vertex (a, none, none, none).
  /// Corners ascend; rows are in lexicographic order. Empty if there are tetrahedra.
  std::vector<std::array<std::uint32_t, 4>> flat;
  std::vector<Duplicate> duplicates;  ///< balls equal to one of lower index; ascending by index
  /// The distinct balls without a cell: in no row of `simplices` and `flat`; ascending. At each center, only the
  /// largest ball can have a cell. If a cell has no volume, the perturbation decides.
  std::vector<std::uint32_t> hidden;
  std::size_t distinct = 0;  ///< number of distinct balls, hidden ones included
};

/// Computes the regular triangulation of the balls with these centers and radii. Options are those of solid().
/// Requires: one radius for each center; finite numbers; radii of at least 0; fewer than 2^32 − 4 balls; at most 2^30
///           tetrahedra.
/// Throws:   InvalidInput that names the violated requirement, before anything is computed unless there are too many
///           tetrahedra; Cancelled.
RBPA_API RegularTriangulation regular_triangulation(std::span<const Point3> centers, std::span<const double> radii,
                                                    const SolidOptions& options = {});

}  // namespace rbpa
