// Small meshes with names, and queries of any mesh.
#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <string>
#include <vector>

#include "meshops/core/connectivity.h"

namespace meshops::test {

/// OpenMesh's default mesh (float points), with the status that deletion needs.
struct TestMesh : OpenMesh::PolyMesh_ArrayKernelT<> {
  TestMesh() {
    request_vertex_status();
    request_edge_status();
    request_halfedge_status();
    request_face_status();
  }
};

/// Makes `count` separate triangles; returns the boundary halfedges, three per triangle, along its boundary curve:
/// element 3t + i runs opposite to side i of triangle t.
std::vector<Halfedge> separate_triangles(Connectivity& mesh, int count);

/// Strip of triangles, with its two end edges, which can be glued to make a band: an annulus of `length` pairs.
struct Strip {
  Halfedge left, right;
};
Strip strip(Connectivity& mesh, int pairs);

/// Returns the faces as cyclic lists of vertex labels with the mates of their edges, in a form in which isomorphic
/// meshes with the same labels are equal: one string per face, sorted. `label` of a vertex need not be unique.
std::vector<std::string> canonical_faces(const Connectivity& mesh, const std::vector<int>& label);

}  // namespace meshops::test
