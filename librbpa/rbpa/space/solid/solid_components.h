// What: finds the components of a solid, with their sizes, volumes and areas.
// Law:  every bit of the measures is a function of the set of points and alpha.
// Cost: union–find over the tetrahedra, and measure() of the boundary.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"

namespace rbpa {

/// The relation by which tetrahedra are connected.
enum class Connection {
  triangles,  ///< a common triangle: the components are bodies whose interior is connected
  points,     ///< a common point, edge or triangle: the components of the union as a topological space
};

/// A component with its measures, in units of the points.
struct SolidComponent {
  std::size_t tetrahedra = 0;
  std::size_t boundary_triangles = 0;
  double volume = 0, area = 0;  ///< of the boundary; errors as in BoundaryMeasures
  Point3 low, high;             ///< opposite corners of the bounding box
};

/// The components of a solid, and the component of each tetrahedron.
struct SolidComponents {
  /// The components by descending volume. Among equal volumes, the component with the lexicographically least boundary
  /// triangle, by coordinates, is first.
  std::vector<SolidComponent> all;
  std::vector<std::uint32_t> number;  ///< for each tetrahedron, its component in `all`
};

/// Computes the components of a solid. An empty solid has none.
/// Requires: `solid` is a solid of `points` with neighbors, and `boundary` is solid_boundary(solid).
/// Throws:   ContractViolation when neighbors are missing, an index does not exist, the boundary is open, or a
///           component has no boundary triangle.
RBPA_API SolidComponents solid_components(std::span<const Point3> points, const Solid& solid,
                                          const SolidBoundary& boundary, Connection through = Connection::triangles);

}  // namespace rbpa
