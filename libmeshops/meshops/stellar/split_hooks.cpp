#include "meshops/stellar/split_hooks.h"

#include <algorithm>

#include "meshops/stellar/relink.h"
#include "meshops/stellar/undo.h"

namespace meshops::detail {
namespace {

/// Returns whether the collapse of the split's halfedge removes exactly the elements that the split added.
bool is_as_split(const Connectivity& mesh, const SplitEffect& effect) {
  const StarElements& added = effect.added;
  const Halfedge h = effect.halfedge;
  if (!is_live(mesh, h) || close_blocker(mesh, h, Keep::manifold)) return false;
  const Halfedge o = mesh.opposite_halfedge_handle(h);
  std::vector<Edge> edges = {mesh.edge_handle(h)};
  std::vector<Face> faces;
  if (!mesh.is_boundary(h)) {
    edges.push_back(mesh.edge_handle(mesh.prev_halfedge_handle(h)));
    faces.push_back(mesh.face_handle(h));
  }
  if (!mesh.is_boundary(o)) {
    edges.push_back(mesh.edge_handle(mesh.next_halfedge_handle(o)));
    faces.push_back(mesh.face_handle(o));
  }
  return mesh.to_vertex_handle(o) == added.vertex && std::ranges::equal(edges, added.edges()) &&
         std::ranges::equal(faces, added.faces());
}

template <typename Element>
bool are_last(std::span<const Element> elements, std::size_t count) {
  return static_cast<std::size_t>(elements.back().idx()) + 1 == count;
}

}  // namespace

void copy_edge_properties(Connectivity& mesh, Halfedge from, Halfedge heir) {
  mesh.copy_all_properties(mesh.edge_handle(from), mesh.edge_handle(heir), true);
  mesh.copy_all_properties(from, heir, true);
  mesh.copy_all_properties(mesh.opposite_halfedge_handle(from), mesh.opposite_halfedge_handle(heir), true);
}

void carry_over(Connectivity& mesh, const SplitEdgeEffect& effect) {
  copy_edge_properties(mesh, effect.line, effect.halfedge);
  const Halfedge line[] = {effect.line, mesh.opposite_halfedge_handle(effect.line)};
  const Halfedge half[] = {effect.halfedge, mesh.opposite_halfedge_handle(effect.halfedge)};
  for (const unsigned side : {0U, 1U})
    if (!mesh.is_boundary(line[side]))
      mesh.copy_all_properties(mesh.face_handle(line[side]), mesh.face_handle(half[side]), true);
}

void carry_over(Connectivity& mesh, const SplitFaceEffect& effect) {
  for (const Face f : effect.added.faces()) mesh.copy_all_properties(effect.face, f, true);
}

void carry_over(Connectivity& mesh, const SplitVertexEffect& effect) {
  const Halfedge h = effect.halfedge, o = mesh.opposite_halfedge_handle(h);  // v→w and back
  mesh.copy_all_properties(mesh.to_vertex_handle(h), effect.added.vertex, true);
  if (!mesh.is_boundary(h))
    copy_edge_properties(mesh, mesh.next_halfedge_handle(h),
                         mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h)));
  if (!mesh.is_boundary(o))
    copy_edge_properties(mesh, mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(o)),
                         mesh.next_halfedge_handle(o));
}

void take_back(Connectivity& mesh, const WeldEffect& effect) {
  try {
    undo(mesh, effect);
  } catch (const ContractViolation&) {
    // If the hook changed links, undo() may refuse: the mesh is then sound, and the collapse stays.
  }
}

void take_back(Connectivity& mesh, const SplitEffect& effect) {
  // If the hook changed links so that the split cannot be undone, the split stays.
  if (!is_as_split(mesh, effect)) return;
  const StarElements& added = effect.added;
  const bool is_at_end = static_cast<std::size_t>(added.vertex.idx()) + 1 == mesh.n_vertices() &&
                         are_last(added.edges(), mesh.n_edges()) && are_last(added.faces(), mesh.n_faces());
  if (is_at_end) {
    close_links(mesh, effect.halfedge);
    mesh.resize(mesh.n_vertices() - 1, mesh.n_edges() - added.edges().size(), mesh.n_faces() - added.faces().size());
  } else if (has_status(mesh)) {  // the hook added elements after the elements of the split
    close_edge(mesh, effect.halfedge);
  }
}

}  // namespace meshops::detail
