// First steps of a user of the mesh operators alone.
#include "meshops/meshops.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

int main() {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  meshops::create_triangle(mesh);
  return meshops::count_topology(mesh).boundary_curves == 1 && meshops::validate(mesh).empty() ? 0 : 1;
}
