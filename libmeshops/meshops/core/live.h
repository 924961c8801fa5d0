// What: tells which handles of a mesh are live, visits live elements, and gives a mesh the status by which elements are
//       marked deleted.
#pragma once

#include <cstddef>
#include <optional>

#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Returns whether the handle is in range and its element is not marked deleted. A halfedge counts as deleted if its
/// edge is marked deleted. In a mesh without status, no element is marked deleted. Cost: constant.
inline bool is_live(const Connectivity& mesh, Vertex v) {
  // The qualified calls of n_…() avoid calls of virtual functions, which no mesh type overrides.
  return v.idx() >= 0 && static_cast<std::size_t>(v.idx()) < mesh.Connectivity::n_vertices() &&
         !(mesh.has_vertex_status() && mesh.status(v).deleted());
}
inline bool is_live(const Connectivity& mesh, Edge e) {
  return e.idx() >= 0 && static_cast<std::size_t>(e.idx()) < mesh.Connectivity::n_edges() &&
         !(mesh.has_edge_status() && mesh.status(e).deleted());
}
inline bool is_live(const Connectivity& mesh, Halfedge h) {
  return h.idx() >= 0 && static_cast<std::size_t>(h.idx()) < mesh.Connectivity::n_halfedges() &&
         is_live(mesh, mesh.edge_handle(h));
}
inline bool is_live(const Connectivity& mesh, Face f) {
  return f.idx() >= 0 && static_cast<std::size_t>(f.idx()) < mesh.Connectivity::n_faces() &&
         !(mesh.has_face_status() && mesh.status(f).deleted());
}

/// Returns whether elements of every kind can be marked deleted in the mesh.
inline bool has_status(const Connectivity& mesh) {
  return mesh.has_vertex_status() && mesh.has_halfedge_status() && mesh.has_edge_status() && mesh.has_face_status();
}

/// Requests status of every kind that the mesh lacks, so that elements of every kind can be marked deleted.
inline void request_status(Connectivity& mesh) {
  if (!mesh.has_vertex_status()) mesh.request_vertex_status();
  if (!mesh.has_halfedge_status()) mesh.request_halfedge_status();
  if (!mesh.has_edge_status()) mesh.request_edge_status();
  if (!mesh.has_face_status()) mesh.request_face_status();
}

namespace detail {

/// Returns the reason why elements of the mesh cannot be deleted, or nothing when they can.
inline std::optional<Blocker> status_blocker(const Connectivity& mesh) {
  return has_status(mesh) ? std::nullopt : std::optional(Blocker(BlockerKind::no_status));
}
inline void require_status(const Connectivity& mesh, const char* operation) {
  enforce(operation, status_blocker(mesh));
}

}  // namespace detail

/// Calls visit(element) for every live element of the kind, in ascending order of handles. Elements that visit() adds,
/// or marks deleted before their turn, are not visited.
/// Requires: visit() does not collect garbage; not checked.
/// Cost:     linear in the number of elements of the kind, including elements marked deleted.
template <typename Visit>
void for_each_vertex(const Connectivity& mesh, Visit visit) {
  for (int i = 0, n = static_cast<int>(mesh.n_vertices()); i < n; ++i)
    if (const Vertex v(i); is_live(mesh, v)) visit(v);
}
template <typename Visit>
void for_each_edge(const Connectivity& mesh, Visit visit) {
  for (int i = 0, n = static_cast<int>(mesh.n_edges()); i < n; ++i)
    if (const Edge e(i); is_live(mesh, e)) visit(e);
}
template <typename Visit>
void for_each_halfedge(const Connectivity& mesh, Visit visit) {
  for (int i = 0, n = static_cast<int>(mesh.n_halfedges()); i < n; ++i)
    if (const Halfedge h(i); is_live(mesh, h)) visit(h);
}
template <typename Visit>
void for_each_face(const Connectivity& mesh, Visit visit) {
  for (int i = 0, n = static_cast<int>(mesh.n_faces()); i < n; ++i)
    if (const Face f(i); is_live(mesh, f)) visit(f);
}

}  // namespace meshops
