#include "meshops/stellar/remove_vertex.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

struct Choice {
  Halfedge along;
  std::optional<Blocker> blocker{};
};

Choice choose(const Connectivity& mesh, Vertex v, Keep keep) {
  if (const auto reason = detail::status_blocker(mesh)) return {Halfedge(), reason};
  if (!is_live(mesh, v)) return {Halfedge(), Blocker(BlockerKind::missing, v)};
  if (mesh.is_isolated(v)) return {Halfedge(), Blocker(BlockerKind::isolated, v)};
  const Halfedge first = mesh.halfedge_handle(v);
  Choice choice{first, detail::close_blocker(mesh, first, keep)};
  if (!choice.blocker) return choice;
  for (Halfedge out = detail::cw(mesh, first); out != first; out = detail::cw(mesh, out))
    if (!detail::close_blocker(mesh, out, keep)) return {out};
  return choice;
}

}  // namespace

std::optional<Blocker> remove_vertex_blocker(const Connectivity& mesh, Vertex v, Keep keep) {
  return choose(mesh, v, keep).blocker;
}

WeldEffect remove_vertex(Connectivity& mesh, Vertex v, Keep keep) {
  const Choice choice = choose(mesh, v, keep);
  detail::enforce(choice.along.is_valid() ? "remove_vertex: no edge at the vertex can be collapsed" : "remove_vertex",
                  choice.blocker);
  return detail::close_edge(mesh, choice.along);
}

}  // namespace meshops
