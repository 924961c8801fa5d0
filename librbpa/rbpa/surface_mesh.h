// What: a surface of points in space as a halfedge mesh.
// Law:  an oriented 2-manifold with boundary, glued as the surface is. Every fan of triangles at a point has a vertex of its
//       own.
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
  std::vector<std::uint32_t> input_index;  ///< the input point of each vertex; ascending
};

/// Requires: a surface of these points.
/// Throws:   InvalidInput when it has more than 357,913,941 triangles, whose halfedges OpenMesh can number; ContractViolation
///           when a corner is none of these points, or a triangle is not a neighbour of its neighbour.
RBPA_API SurfaceMesh surface_mesh(std::span<const Point3> points, const Surface& surface);
/// The same for a surface that is no longer needed: its memory is freed on the way.
RBPA_API SurfaceMesh surface_mesh(std::span<const Point3> points, Surface&& surface);

}  // namespace rbpa
