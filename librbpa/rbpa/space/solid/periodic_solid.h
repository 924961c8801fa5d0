// What:   the solid alpha complex of points in a periodic box, as in a simulation under periodic boundary conditions:
//         tetrahedra whose corners are points of the box or images of them.
// Law:    a function of the set of points, the box and alpha. Along each axis, the side and the coordinates modulo the
//         side are rounded to multiples of 2⁻⁵¹ of the power of two above the side, so that all images are doubles. For
//         these points everything is exact, ties as in solid(). Moving all points by such multiples changes nothing.
// How:    the points with their images around the box form one solid, of which one tetrahedron of each class is kept.
//         docs/explanation/space.md, section 23.
// Cost:   that of solid() for the points and the images that are within twice the largest radius of the box.
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

/// The image of a point of the box, moved by `offset` boxes along each axis.
struct PeriodicVertex {
  std::uint32_t point = 0;
  std::array<std::int8_t, 3> offset = {0, 0, 0};
  friend bool operator==(const PeriodicVertex&, const PeriodicVertex&) = default;
  friend bool operator<(const PeriodicVertex& a, const PeriodicVertex& b) {
    return a.point != b.point ? a.point < b.point : a.offset < b.offset;
  }
};

/// The tetrahedra, one of all images of each: the one whose corner of the least index is in the box. Its corners are
/// four different points.
struct PeriodicSolid {
  Point3 box;                            ///< the sides, rounded
  std::vector<PeriodicVertex> vertices;  ///< all corners, ascending
  std::vector<Point3> positions;         ///< positions of the vertices: point modulo box, plus offset times box; exact
  /// The tetrahedra as in Solid, with vertices for corners.
  std::vector<std::array<std::uint32_t, 4>> simplices;
  /// The tetrahedron one of whose images lies across from each corner, or Solid::none.
  std::vector<std::array<std::uint32_t, 4>> neighbors;
  std::vector<Duplicate> duplicates;    ///< points that are equal modulo the box; ascending by index
  std::vector<std::uint32_t> isolated;  ///< distinct points in no tetrahedron, ascending
  std::size_t distinct = 0;             ///< number of distinct points
};

/// Computes the Delaunay tetrahedra of circumradius at most alpha, of points and all their images. At infinity, all of
/// them.
/// Requires: as solid(); sides of the box from 2⁻⁹⁰⁰ to 2⁹⁰⁰; alpha below half of the least side, or no empty ball of
///           that radius.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API PeriodicSolid periodic_solid(std::span<const Point3> points, const Point3& box, double alpha,
                                      const SolidOptions& options = {});

/// Returns the tetrahedra of `solid` with points as corners, without offsets. It serves functions that need neighbors
/// and radii, but no positions: min_alpha(), auto_alpha().
RBPA_API Solid without_offsets(const PeriodicSolid& solid);

/// Returns the triangles that have a tetrahedron on one side only, each at the place of that tetrahedron; corners are
/// vertices, counter-clockwise seen from outside. They form a closed surface if images of an edge count as one.
/// Requires: neighbors.
/// Throws:   ContractViolation when there are none.
RBPA_API std::vector<Triangle> periodic_boundary(const PeriodicSolid& solid);

/// Returns the tetrahedra of radius at most alpha, like within() of a Solid, with the vertices that are their corners.
/// Requires: the radius of each tetrahedron.
/// Throws:   ContractViolation when the number of radii is wrong; InvalidInput when alpha is not above 0.
RBPA_API PeriodicSolid within(const PeriodicSolid& solid, std::span<const double> radii, double alpha);

}  // namespace rbpa
