// What: short names for OpenMesh's halfedge connectivity and its handles.
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

namespace meshops {

/// The base class of every OpenMesh mesh type, whatever the traits of the type.
using Connectivity = OpenMesh::PolyConnectivity;

using Vertex = OpenMesh::VertexHandle;
using Halfedge = OpenMesh::HalfedgeHandle;
using Edge = OpenMesh::EdgeHandle;
using Face = OpenMesh::FaceHandle;

}  // namespace meshops
