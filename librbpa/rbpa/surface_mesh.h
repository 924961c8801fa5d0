// What: a surface of points in space as a halfedge mesh.
// Law:  an oriented 2-manifold with boundary; its sides are glued as those of the surface are. Every fan of triangles at a
//       point has a vertex of its own.
// Cost: linear, and a sort of the vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/mesh.h"
#include "rbpa/surface.h"

namespace rbpa {

struct SurfaceMesh {
  Mesh mesh;                               ///< face i is triangle i of the surface, with the same orientation
  std::vector<std::uint32_t> input_index;  ///< of each vertex of the mesh, the input point it stands on; ascending
};

/// Requires: a surface of these points.
/// Throws:   InvalidInput when it has more triangles than OpenMesh can number the halfedges of, 357,913,941; ContractViolation
///           when it is none of these points, or its neighbours do not know each other.
RBPA_API SurfaceMesh surface_mesh(std::span<const Point3> points, const Surface& surface);
/// The same of a surface that is not needed any more: its memory is given back on the way.
RBPA_API SurfaceMesh surface_mesh(std::span<const Point3> points, Surface&& surface);

}  // namespace rbpa
