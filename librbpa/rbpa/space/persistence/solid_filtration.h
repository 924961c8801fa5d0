// What:   computes the full alpha complex of points in space at every radius: all simplices of the Delaunay
//         triangulation, and the radius at which each appears. For points in a plane or on a line, triangles and edges
//         are those of the Delaunay triangulation of the plane or line.
// Law:    a simplex is in the full alpha complex of alpha exactly if its radius is at most alpha, for every double
//         alpha > 0: radii are rounded up. No face of a simplex has a greater radius than the simplex. The result is a
//         function of the set of points, except the indices of corners and the order of corners in a row.
// Cost:   about twice that of solid() (docs/explanation/filtration_and_persistence.md, sections 9 to 12); threads share
//         the computation of the radii.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4;
//         docs/explanation/filtration_and_persistence.md, sections 9 to 12.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// Simplices with the radius of each, in units of the points; infinity stands for a radius above all doubles. Corners
/// are input indices; the lowest index of equal points stands for all of them.
struct SolidFiltration {
  /// The tetrahedra of solid() at infinity, with neighbors. They are in the order of a space-filling curve in place of
  /// lexicographic order, so that tetrahedra near each other and their faces are near in memory. Rows are positively
  /// oriented and begin with any corner. There are no tetrahedra if all points are in a plane.
  Solid delaunay;
  std::vector<double> tetrahedron_alpha;  ///< the radius of each tetrahedron
  /// The triangles, with ascending corners, in the order of the first tetrahedron of each. If there are no tetrahedra,
  /// the order of triangles and edges is unspecified.
  std::vector<Triangle> triangles;
  std::vector<double> triangle_alpha;               ///< the radius of each triangle
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< with ascending corners; in the order of their first triangles
  std::vector<double> edge_alpha;                   ///< the radius of each edge

  /// For each corner of each tetrahedron, the number of the triangle across from the corner.
  std::vector<std::array<std::uint32_t, 4>> triangles_of;
  /// For each corner of each triangle, the number of the edge across from the corner.
  std::vector<std::array<std::uint32_t, 3>> edges_of;

  /// The radius of each point; infinity for a point that is not in the triangulation. Empty if all radii are 0, as in
  /// the result of solid_filtration().
  std::vector<double> point_alpha;
};

/// Computes the filtration, with neighbors whatever the value of options.neighbors. After the triangulation,
/// options.progress is called with the number of distinct points as the number of finished points.
/// Requires: finite points, fewer than 2^32 − 1; at most 2^30 Delaunay tetrahedra.
/// Throws:   InvalidInput that names the violated requirement: before anything is computed, except for too many
///           tetrahedra; Cancelled.
RBPA_API SolidFiltration solid_filtration(std::span<const Point3> points, const SolidOptions& options = {});

}  // namespace rbpa
