// What:   computes the solid alpha complex of points in a periodic box, as in a simulation under periodic boundary
//         conditions: tetrahedra whose corners are points of the box or images of them.
// Law:    the tetrahedra are a function of the set of points, the box and alpha. Along each axis, the side and the
//         coordinates modulo the side are rounded to multiples of 2⁻⁵¹ of the power of two above the side, so that all
//         images are doubles. For the rounded points every decision is exact, with ties as in solid(). If no side or
//         coordinate needs rounding, moving all points by multiples of the rounding unit changes only offsets and
//         positions.
// How:    solid() is computed for the points and their images around the box; one image of each tetrahedron is kept.
//         docs/explanation/space.md, section 23.
// Cost:   that of solid() for the points and the images at most 2r outside of the box. r begins at twice the mean
//         spacing of points and doubles until the tetrahedra fill the space or r is alpha, or nearly half of a side.
// Source: Caroli and Teillaud, Computing 3D periodic triangulations (2009).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// The image of an input point, moved from its place in the box by `offset` boxes along each axis: −1, 0 or 1.
struct PeriodicVertex {
  std::uint32_t point = 0;  ///< input index; the lowest one of points that are equal modulo the box
  std::array<std::int8_t, 3> offset = {0, 0, 0};
  friend bool operator==(const PeriodicVertex&, const PeriodicVertex&) = default;
  friend bool operator<(const PeriodicVertex& a, const PeriodicVertex& b) {
    return a.point != b.point ? a.point < b.point : a.offset < b.offset;
  }
};

/// The tetrahedra of a periodic complex. One image of each tetrahedron is listed: the image whose corner of least input
/// index is in the box. The corners of a tetrahedron are images of four different points.
struct PeriodicSolid {
  Point3 box;                            ///< the sides, rounded as `Law` above says, in units of the points
  std::vector<PeriodicVertex> vertices;  ///< all corners, sorted by point, then by offset
  /// Positions of the vertices: the rounded point in the box plus offset times side, without a further rounding.
  std::vector<Point3> positions;
  /// The tetrahedra, oriented and sorted as Solid::simplices. Corners are indices in `vertices`.
  std::vector<std::array<std::uint32_t, 4>> simplices;
  /// For each corner of each tetrahedron, the tetrahedron that has an image across from this corner, or Solid::none.
  /// Empty unless requested.
  std::vector<std::array<std::uint32_t, 4>> neighbors;
  std::vector<Duplicate> duplicates;    ///< points equal modulo the box to one of lower index; ascending
  std::vector<std::uint32_t> isolated;  ///< distinct points in no tetrahedron, ascending
  std::size_t distinct = 0;             ///< number of distinct points
};

/// Computes the Delaunay tetrahedra of circumradius at most alpha, of the points and all their images. An infinite
/// alpha gives all Delaunay tetrahedra. Points may be outside of the box: coordinates count modulo the box. Progress
/// counts the points and images of one search, and restarts with each repeated search.
/// Requires: the points and their images near the box meet the requirements of solid(); sides of the box from 2⁻⁹⁰⁰ to
///           2⁹⁰⁰; alpha below half of the least side, or so many points that no ball of half that side is empty.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API PeriodicSolid periodic_solid(std::span<const Point3> points, const Point3& box, double alpha,
                                      const SolidOptions& options = {});

/// Returns the tetrahedra of `solid` in their order with input indices as corners, and with neighbors if `solid` has
/// neighbors. The result is for functions that need no positions, as min_alpha() and auto_alpha(). Rows of the result
/// may not be in lexicographic order. Cost: linear.
RBPA_API Solid without_offsets(const PeriodicSolid& solid);

/// Returns the triangles that have a tetrahedron on one side only. Corners are indices in `vertices`, counter-clockwise
/// seen from outside. Triangles are sorted by tetrahedron, then by the corner across from the triangle. The triangles
/// form a closed surface if all images of an edge count as one edge. Cost: linear.
/// Requires: `solid` has neighbors.
/// Throws:   ContractViolation when neighbors are missing.
RBPA_API std::vector<Triangle> periodic_boundary(const PeriodicSolid& solid);

/// Returns the tetrahedra whose radius is at most alpha, and the vertices that are their corners, with neighbors if
/// `solid` has neighbors. Cost: linear.
/// Requires: `radii` are circumradii() of the positions and simplices of `solid`, of which only the number is checked.
/// Throws:   ContractViolation when the number of radii differs; InvalidInput when alpha is not above 0.
RBPA_API PeriodicSolid within(const PeriodicSolid& solid, std::span<const double> radii, double alpha);

}  // namespace rbpa
