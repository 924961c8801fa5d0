// What:   computes the solid alpha complex of points in space: their Delaunay tetrahedra of circumradius at most alpha,
//         as arrays of indices in canonical order. At infinity, the Delaunay triangulation.
// Law:    the tetrahedra are a function of the set of points and alpha. Every decision is exact, on any finite input.
//         Ties are decided by the symbolic perturbation of CGAL, whose Delaunay_triangulation_3 has the same
//         tetrahedra. docs/explanation/space.md.
// Cost:   for uniform points in a volume about 7 tetrahedra, 420 bytes and, in one thread, 2.5 microseconds a point; up
//         to three times that time on grids, twice that memory where points are inserted one by one (measured in
//         docs/explanation/space.md, section 16). Time and number of tetrahedra are quadratic in the worst case: points
//         on the moment curve.
// Source: Bowyer (1981), Watson (1981); Amenta, Choi, Rote, Incremental constructions con BRIO (2003); Edelsbrunner and
//         Mücke, Three-dimensional alpha shapes (1994).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

struct SolidOptions {
  bool neighbors = true;     ///< whether Solid::neighbors is filled in
  MaxThreads threads = 0;    ///< 0: all processors
  OnProgress progress = {};  ///< Progress::triangles is the number of finished points
};

/// Tetrahedra with their neighbors. Corners are input indices; the lowest index of equal points stands for all of them.
struct Solid {
  /// The value for no neighbor in `neighbors`.
  static constexpr std::uint32_t none = 0xffffffff;

  /// The tetrahedra. Each is positively oriented: (b − a) × (c − a) · (d − a) > 0 for corners a, b, c, d; a is the
  /// corner of lowest index, b the corner of second lowest index. Rows are in lexicographic order.
  std::vector<std::array<std::uint32_t, 4>> simplices;
  /// For each corner of each tetrahedron, the tetrahedron across from this corner, or none where the complex ends.
  /// Empty if SolidOptions::neighbors is false.
  std::vector<std::array<std::uint32_t, 4>> neighbors;
  std::vector<Duplicate> duplicates;    ///< points equal to one of lower index; ascending by index
  std::vector<std::uint32_t> isolated;  ///< distinct points in no tetrahedron, ascending
  std::size_t distinct = 0;             ///< number of distinct points
};

/// Computes the Delaunay tetrahedra of circumradius at most alpha. The result has no tetrahedra for fewer than four
/// points and for points in one plane.
/// Requires: 0 < alpha ≤ infinity; finite points, fewer than 2^32 − 1; at most 2^30 Delaunay tetrahedra.
/// Throws:   InvalidInput that names the violated requirement: before anything is computed, except for too many
///           tetrahedra; Cancelled.
RBPA_API Solid solid(std::span<const Point3> points, double alpha, const SolidOptions& options = {});

}  // namespace rbpa
