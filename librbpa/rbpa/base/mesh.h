// What: the halfedge mesh that librbpa returns.
#pragma once

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace rbpa {

/// Traits of the mesh. Coordinates are doubles, as OpenMesh's default, float, cannot hold the input.
struct MeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

using Mesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

}  // namespace rbpa
