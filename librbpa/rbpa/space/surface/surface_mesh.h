// What: converts a surface of points in space to a halfedge mesh, and a halfedge mesh to a surface.
// Law:  the mesh is an oriented 2-manifold with boundary, glued as the surface is. Every fan of triangles at a point
//       has a vertex of its own. The surface of a mesh is glued as the mesh is; the surface_mesh() of that surface is
//       the mesh again, up to handles and isolated vertices.
// Cost: linear, and a sort of the vertices; surface_of() also sorts the triangles.
#pragma once

#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/core/live_range.h"
#include "meshops/stellar/split_hooks.h"
#include "rbpa/base/api.h"
#include "rbpa/base/mesh.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"
#include "rbpa/space/surface/surface_of.h"

namespace rbpa {

struct SurfaceMesh {
  /// Mesh without status (meshops::request_status()); face i is triangle i of the surface, with the same orientation.
  Mesh mesh;
  /// The input index of the point of each vertex, ascending. A point has one vertex for each of its fans.
  std::vector<std::uint32_t> input_index;
};

/// Builds the halfedge mesh of a surface.
/// Requires: `surface` is a surface of `points`.
/// Throws:   InvalidInput when the surface has more than 357,913,941 triangles, for which OpenMesh cannot number the
///           halfedges; ContractViolation as require_linked() (triangle_arrays.h) throws it.
RBPA_API SurfaceMesh surface_mesh(std::span<const Point3> points, const Surface& surface);
/// Builds the halfedge mesh as above, and empties `surface` as soon as possible, to free its memory.
RBPA_API SurfaceMesh surface_mesh(std::span<const Point3> points, Surface&& surface);

/// Returns the position of each vertex of an OpenMesh mesh in space, by index; the origin for vertices marked deleted.
template <meshops::HasPoints AnyMesh>
requires(OpenMesh::vector_traits<typename AnyMesh::Point>::size_ ==
         3) std::vector<Point3> places_of(const AnyMesh& mesh) {
  std::vector<Point3> places(mesh.n_vertices());
  for (const meshops::Vertex v : meshops::live_vertices(mesh)) {
    const auto& p = mesh.point(v);
    places[static_cast<std::size_t>(v.idx())] = {static_cast<double>(p[0]), static_cast<double>(p[1]),
                                                 static_cast<double>(p[2])};
  }
  return places;
}

/// Returns the triangles of a mesh as a surface. Corners are indices of vertices, and `given` has for each triangle the
/// index of its face. Of vertices at one place, the lowest stands for all, glued or not. Vertices marked deleted are
/// left out.
/// Requires: validate(mesh) is empty; triangles only; a finite place of each vertex that is not marked deleted;
///           different places of a face's corners.
/// Throws:   ContractViolation when a face is no triangle or there are fewer places than vertices; InvalidInput as
///           surface_of() of triangles throws it.
RBPA_API SurfaceOfTriangles surface_of(const meshops::Connectivity& mesh, std::span<const Point3> places);
/// Returns the triangles of a mesh whose vertices have positions, as above, with `places` = places_of(mesh).
template <meshops::HasPoints AnyMesh>
SurfaceOfTriangles surface_of(const AnyMesh& mesh) {
  return surface_of(mesh, places_of(mesh));
}

}  // namespace rbpa
