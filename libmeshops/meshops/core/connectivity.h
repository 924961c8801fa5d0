// What: short names for OpenMesh's halfedge connectivity and its handles.
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

namespace meshops {

/// The connectivity of any OpenMesh mesh, whatever its traits: every mesh type derives from it.
using Connectivity = OpenMesh::PolyConnectivity;

using Vertex = OpenMesh::VertexHandle;
using Halfedge = OpenMesh::HalfedgeHandle;
using Edge = OpenMesh::EdgeHandle;
using Face = OpenMesh::FaceHandle;

}  // namespace meshops
