// What: the boundary of a solid as a closed surface, made of the triangles with a tetrahedron on one side only; its
//       volume and area.
// Law:  a function of the set of tetrahedra. At an edge of four, six, … boundary triangles, neighbors are those that
//       bound the same wedge of tetrahedra. Each fan of triangles around a point thus has a vertex of its own in
//       split_fans() and surface_mesh(). docs/explanation/space.md, section 17.
// Cost: one look at the neighbors of every tetrahedron; the rest is linear in the tetrahedra around edges of the
//       boundary.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

struct SolidBoundary {
  /// The boundary triangles, oriented as seen from outside. Neighbors lie across their sides, through the solid; none
  /// is missing.
  Surface surface;
  std::vector<std::uint32_t> tetrahedra;  ///< for each triangle, the tetrahedron behind it
};

/// Returns the boundary of a solid.
/// Requires: a solid with neighbors.
/// Throws:   ContractViolation when neighbors are missing, or those around an edge of the boundary do not share a face.
RBPA_API SolidBoundary solid_boundary(const Solid& solid);

/// Returns the triangles of a boundary, glued through the outside: where several wedges of tetrahedra meet at an edge,
/// a triangle is the neighbor of the next one around the edge across the empty space in front of it. Voids are then
/// closed surfaces, and bodies that touch along an edge are one.
/// Requires: the boundary of a solid of these points.
/// Throws:   ContractViolation on others.
/// Cost:     linear, and a sort at such edges.
RBPA_API Surface glued_outside(std::span<const Point3> points, const Surface& boundary);

struct BoundaryMeasures {
  double volume = 0;  ///< of the solid, with a relative error of at most 2⁻⁵²; by the divergence theorem
  /// Area, with an error of at most 2⁻⁵⁰ of the sum, over all triangles, of the product of two of their sides.
  double area = 0;
};

/// Returns volume and area as exact sums, rounded once: the same bytes in any order of the points. The bound on the
/// volume holds if along each axis the greatest coordinate of the triangles is less than 2⁷⁰⁰ times the least nonzero
/// one. Measures beyond the range of double are infinite.
/// Requires: the boundary of a solid of these points.
/// Throws:   ContractViolation when a corner is none of them.
RBPA_API BoundaryMeasures measure(std::span<const Point3> points, const Surface& boundary);

}  // namespace rbpa
