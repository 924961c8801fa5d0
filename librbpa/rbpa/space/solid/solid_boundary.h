// What: finds the boundary of a solid, all triangles with a tetrahedron on one side only, and measures volume and area.
// Law:  the boundary is a function of the set of tetrahedra. Where four, six or more boundary triangles share an edge,
//       two are neighbors if they bound the same wedge of tetrahedra. Each fan of triangles around a point thus has a
//       vertex of its own in split_fans() and surface_mesh(). docs/explanation/space.md, section 17.
// Cost: linear in the tetrahedra, and a sort of the boundary triangles; shared among threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// The boundary of a solid, and the tetrahedron of each triangle.
struct SolidBoundary {
  /// The boundary triangles, counter-clockwise seen from outside the solid, each with its least index first, in
  /// lexicographic order. A turn about a side through the solid leads from a triangle to its neighbor across the side;
  /// every side has a neighbor.
  Surface surface;
  std::vector<std::uint32_t> tetrahedra;  ///< for each triangle, the tetrahedron behind it
};

/// Returns the boundary of a solid. The boundary of an empty solid is empty.
/// Requires: `solid` has neighbors.
/// Throws:   ContractViolation when neighbors are missing; also when, around a boundary edge, a neighbor does not share
///           the face or a tetrahedron is not positively oriented. Other tetrahedra are not checked.
RBPA_API SolidBoundary solid_boundary(const Solid& solid, MaxThreads threads = 0);

/// Returns the triangles of a boundary in their order, glued through the outside: where several wedges of tetrahedra
/// meet at an edge, the neighbor of a triangle is the next triangle around the edge across the empty space in front of
/// the triangle. Each void is then bounded by closed surfaces, and bodies that touch along an edge have one surface.
/// Requires: `boundary` is the boundary of a solid of `points`.
/// Throws:   ContractViolation when a corner does not exist, or a side has no neighbor or one that is not mutual.
/// Cost:     linear, and a sort at each edge where several wedges meet.
RBPA_API Surface glued_outside(std::span<const Point3> points, const Surface& boundary);

/// The volume that a boundary encloses, and the area of the boundary.
struct BoundaryMeasures {
  double volume = 0;  ///< in cubed units of the points; relative error at most 2⁻⁵²
  /// Area, in squared units. The error is at most 2⁻⁵⁰ times the sum, over all triangles, of the product of two sides.
  double area = 0;
};

/// Returns volume (by the divergence theorem) and area. Terms are summed without rounding errors, so that the result
/// does not depend on the order of the points. The bound on the volume holds if along each axis the greatest absolute
/// coordinate of the triangles is less than 2⁷⁰⁰ times the least nonzero one. A measure beyond the range of double is
/// infinite. The measures of an empty boundary are 0.
/// Requires: `boundary` is the boundary of a solid of `points`; that it is closed is not checked.
/// Throws:   ContractViolation when a corner is not an index of a point.
/// Cost:     linear in the triangles and points.
RBPA_API BoundaryMeasures measure(std::span<const Point3> points, const Surface& boundary);

}  // namespace rbpa
