// What: finds the boundary of a solid, a closed surface of all triangles with a single tetrahedron, and measures the
//       volume and area of the boundary.
// Law:  the boundary is a function of the set of tetrahedra. Where four, six or more boundary triangles share an edge,
//       two are neighbors if they bound the same wedge of tetrahedra. Each fan of triangles around a point thus has a
//       vertex of its own in split_fans() and surface_mesh(). docs/explanation/space.md, section 17.
// Cost: one look at the neighbors of each tetrahedron; the rest is linear in the tetrahedra around boundary edges, with
//       a sort of the boundary triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// The boundary of a solid, and the tetrahedron of each triangle.
struct SolidBoundary {
  /// The boundary triangles, counter-clockwise seen from outside the solid, each with its least index first, in
  /// lexicographic order. The neighbor across a side is reached by turning about the side through the solid; every side
  /// has a neighbor.
  Surface surface;
  std::vector<std::uint32_t> tetrahedra;  ///< for each triangle, the tetrahedron behind it
};

/// Returns the boundary of a solid, empty if the solid is.
/// Requires: `solid` has neighbors.
/// Throws:   ContractViolation when neighbors are missing; also when, around a boundary edge, a neighbor does not share
///           the face or tetrahedra are not positively oriented. Other tetrahedra are not checked.
RBPA_API SolidBoundary solid_boundary(const Solid& solid);

/// Returns the triangles of a boundary in their order, glued through the outside: where several wedges of tetrahedra
/// meet at an edge, the neighbor of a triangle is the next triangle around the edge, across the empty space in front of
/// it. Voids are then closed surfaces, and bodies that touch along an edge are one.
/// Requires: `boundary` is the boundary of a solid of `points`.
/// Throws:   ContractViolation when a corner does not exist, or a side has no neighbor or one that is not mutual.
/// Cost:     linear, and a sort at edges where several wedges meet.
RBPA_API Surface glued_outside(std::span<const Point3> points, const Surface& boundary);

/// The volume that a boundary encloses, and its area.
struct BoundaryMeasures {
  double volume = 0;  ///< in cubed units of the points; relative error at most 2⁻⁵²
  /// Area, in squared units. The error is at most 2⁻⁵⁰ times the sum, over all triangles, of the product of two sides.
  double area = 0;
};

/// Returns volume (by the divergence theorem) and area, summed without rounding errors: the bits are the same in any
/// order of the points. The bound on the volume holds if along each axis the greatest absolute coordinate of the
/// triangles is less than 2⁷⁰⁰ times the least nonzero one. Measures beyond the range of double are infinite; those of
/// an empty boundary are 0.
/// Requires: `boundary` is the boundary of a solid of `points`; whether it is closed is not checked.
/// Throws:   ContractViolation when a corner is not an index of a point.
/// Cost:     linear in the triangles and points.
RBPA_API BoundaryMeasures measure(std::span<const Point3> points, const Surface& boundary);

}  // namespace rbpa
