// What: the halfedge mesh that librbpa returns: a triangle mesh of OpenMesh with coordinates in double.
#pragma once

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace rbpa {

/// The traits of the mesh. Coordinates are doubles: float, the default of OpenMesh, would round the input.
struct MeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

/// Triangle mesh with coordinates in double; points of the plane have z = 0.
using Mesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

}  // namespace rbpa
