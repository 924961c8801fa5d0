// What: short names for OpenMesh's halfedge connectivity and its handles, and for the kinds of elements.
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <cstdint>
#include <string_view>

namespace meshops {

/// Base class of every OpenMesh mesh type; it does not depend on the traits of the type.
using Connectivity = OpenMesh::PolyConnectivity;

using Vertex = OpenMesh::VertexHandle;
using Halfedge = OpenMesh::HalfedgeHandle;
using Edge = OpenMesh::EdgeHandle;
using Face = OpenMesh::FaceHandle;

/// Kind of an element of a mesh.
enum class ElementKind : std::uint8_t { vertex, halfedge, edge, face };

/// Returns the name of a kind: "vertex", "halfedge", "edge" or "face".
constexpr std::string_view name(ElementKind kind) {
  constexpr std::string_view names[] = {"vertex", "halfedge", "edge", "face"};
  return names[static_cast<int>(kind)];
}
/// Returns the kind of element that a handle of this type names.
inline ElementKind kind_of(Vertex) { return ElementKind::vertex; }
inline ElementKind kind_of(Halfedge) { return ElementKind::halfedge; }
inline ElementKind kind_of(Edge) { return ElementKind::edge; }
inline ElementKind kind_of(Face) { return ElementKind::face; }

}  // namespace meshops
