// What: the mesh on which libmeshops and OpenMesh compete, and the queries that both make.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "bench/operator_contest.h"

namespace meshops_bench {

struct TriMesh : OpenMesh::TriMesh_ArrayKernelT<> {
  TriMesh();
};

/// Adds the vertices of a task, with room for its triangles.
void add_vertices(TriMesh& mesh, const Task& task);
/// Builds a mesh by OpenMesh's add_face().
TriMesh mesh_of(const Task& task);
template <>
void copy_with_room(const TriMesh& from, TriMesh& to);
template <>
Shape shape_of(const TriMesh& mesh);

OpenMesh::VertexHandle vertex(std::uint32_t index);
OpenMesh::HalfedgeHandle halfedge(const TriMesh& mesh, std::uint32_t from, std::uint32_t to);

/// Return the handles of a site.
OpenMesh::HalfedgeHandle halfedge_of(const TriMesh& mesh, const Site& site);
OpenMesh::EdgeHandle edge_of(const TriMesh& mesh, const Site& site);
OpenMesh::FaceHandle face_of(const TriMesh& mesh, const Site& site);

}  // namespace meshops_bench
