// What:   computes the solid alpha complex of points in a periodic box, as in a simulation under periodic boundary
//         conditions: tetrahedra whose corners are points of the box or images of them.
// Law:    the tetrahedra are a function of the set of points, the box and alpha. Along each axis, the side and the
//         coordinates modulo the side are rounded to multiples of 2⁻⁵¹ of the power of two above the side, so that all
//         images are doubles. For the rounded points everything is exact, ties as in solid(). If the sides and all
//         coordinates are such multiples, moving all points by one such multiple changes only offsets and positions.
// How:    the points with their images around the box form one solid, of which one image of each tetrahedron is kept.
//         docs/explanation/space.md, section 23.
// Cost:   that of solid() for the points and the images at most 2r outside of the box. r is first twice the mean
//         spacing of points; the search is repeated with 2r until the tetrahedra fill the space, or r is alpha.
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
  std::uint32_t point = 0;  ///< input index; of points that are equal modulo the box the lowest
  std::array<std::int8_t, 3> offset = {0, 0, 0};
  friend bool operator==(const PeriodicVertex&, const PeriodicVertex&) = default;
  friend bool operator<(const PeriodicVertex& a, const PeriodicVertex& b) {
    return a.point != b.point ? a.point < b.point : a.offset < b.offset;
  }
};

/// The tetrahedra of a periodic complex. Of all images of a tetrahedron, the result has the one whose corner of least
/// index is in the box. The corners of a tetrahedron are images of four different points.
struct PeriodicSolid {
  Point3 box;                            ///< the sides, rounded as the law says, in units of the points
  std::vector<PeriodicVertex> vertices;  ///< all corners, sorted by point, then by offset
  /// Positions of the vertices: the rounded point in the box, plus offset times side, without a rounding error.
  std::vector<Point3> positions;
  /// The tetrahedra, oriented and sorted as in Solid. Corners are positions in `vertices`.
  std::vector<std::array<std::uint32_t, 4>> simplices;
  /// For each corner of each tetrahedron, the tetrahedron that has an image across from this corner, or Solid::none.
  /// Empty unless requested.
  std::vector<std::array<std::uint32_t, 4>> neighbors;
  std::vector<Duplicate> duplicates;    ///< points that are equal modulo the box; ascending by index
  std::vector<std::uint32_t> isolated;  ///< distinct points in no tetrahedron, ascending
  std::size_t distinct = 0;             ///< number of distinct points
};

/// Computes the Delaunay tetrahedra of circumradius at most alpha, of the points and all their images; for an infinite
/// alpha, all Delaunay tetrahedra. Points may be anywhere: coordinates count modulo the box. Progress counts the points
/// and images of one search, and begins again with the next.
/// Requires: what solid() requires of the points and the images that are needed; sides of the box from 2⁻⁹⁰⁰ to 2⁹⁰⁰;
///           alpha below half of the least side, or so many points that no ball of half that side is empty.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API PeriodicSolid periodic_solid(std::span<const Point3> points, const Point3& box, double alpha,
                                      const SolidOptions& options = {});

/// Returns the tetrahedra of `solid` with input indices as corners, in the same order, with neighbors if `solid` has
/// neighbors. The result is for functions that need no positions: min_alpha(), auto_alpha(). Its rows may not be in
/// lexicographic order. Cost: linear.
RBPA_API Solid without_offsets(const PeriodicSolid& solid);

/// Returns the triangles that have a tetrahedron on one side only, each with three corners of that tetrahedron:
/// positions in `vertices`, counter-clockwise seen from outside; in the order of tetrahedra and of the corners across.
/// The triangles form a closed surface if all images of an edge count as one edge. Cost: linear.
/// Requires: `solid` has neighbors.
/// Throws:   ContractViolation when neighbors are missing.
RBPA_API std::vector<Triangle> periodic_boundary(const PeriodicSolid& solid);

/// Returns the tetrahedra whose radius is at most alpha, and the vertices that are their corners, with neighbors if
/// `solid` has neighbors. Cost: linear.
/// Requires: `radii` are circumradii() of the positions and simplices of `solid`, of which only the number is checked.
/// Throws:   ContractViolation when the number of radii differs; InvalidInput when alpha is not above 0.
RBPA_API PeriodicSolid within(const PeriodicSolid& solid, std::span<const double> radii, double alpha);

}  // namespace rbpa
