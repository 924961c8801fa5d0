// What: the boundary of a solid: the triangles that have a tetrahedron on one side only, as a closed surface; its volume and area.
// Law:  a function of the set of tetrahedra. Where four, six, … triangles meet at an edge, neighbors are those that bound the same
//       wedge of tetrahedra, so that each fan of triangles around a point has a vertex of its own in split_fans() and
//       surface_mesh(). docs/solid.md, section 7.
// Cost: one look at the neighbors of every tetrahedron; the rest is linear in the tetrahedra around edges of the boundary.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"
#include "rbpa/surface.h"

namespace rbpa {

struct SolidBoundary {
  /// Triangles as in every Surface, seen from outside; neighbors are across their sides, through the solid. None is missing.
  Surface surface;
  std::vector<std::uint32_t> tetrahedra;  ///< of each triangle, the tetrahedron behind it
};

/// Requires: a solid with neighbors.
/// Throws:   ContractViolation when neighbors are missing, or those around an edge of the boundary do not share a face.
RBPA_API SolidBoundary solid_boundary(const Solid& solid);

/// The same triangles glued through what is outside: where several wedges of tetrahedra meet at an edge, a triangle is the neighbor
/// of the next one around it that is not behind it. So voids are closed surfaces, and bodies that touch along an edge are one.
/// Requires: the boundary of a solid of these points. Throws: ContractViolation on others. Cost: linear, and a sort at such edges.
RBPA_API Surface glued_outside(std::span<const Point3> points, const Surface& boundary);

struct BoundaryMeasures {
  double volume = 0;  ///< of the solid, within 2⁻⁵² of itself; by the divergence theorem
  double area = 0;    ///< within 2⁻⁵⁰ of the sum of products of two sides of each triangle
};

/// Exact sums, rounded once: the same bytes in any order of the points. The bound on the volume holds where along each axis the
/// greatest coordinate of the triangles is less than 2⁷⁰⁰ times the least other than 0; measures beyond the range of double are infinite.
/// Requires: the boundary of a solid of these points. Throws: ContractViolation when a corner is none of them.
RBPA_API BoundaryMeasures measure(std::span<const Point3> points, const Surface& boundary);

}  // namespace rbpa
