#include "meshops/stellar/remove_vertex.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

struct Choice {
  Halfedge along;
  const char* refusal = nullptr;
};

Choice choose(const Connectivity& mesh, Vertex v, Keep keep) {
  if (const char* reason = detail::status_refusal(mesh)) return {Halfedge(), reason};
  if (!is_live(mesh, v)) return {Halfedge(), "the vertex does not exist or is deleted"};
  if (mesh.is_isolated(v)) return {Halfedge(), "the vertex is isolated"};
  const Halfedge first = mesh.halfedge_handle(v);
  Choice choice{first, detail::close_refusal(mesh, first, keep)};
  if (!choice.refusal) return choice;
  for (Halfedge out = detail::cw(mesh, first); out != first; out = detail::cw(mesh, out))
    if (!detail::close_refusal(mesh, out, keep)) return {out};
  return choice;
}

std::optional<std::string> reason(const Choice& choice) {
  if (!choice.refusal) return std::nullopt;
  return choice.along.is_valid() ? std::string("no edge at the vertex can be collapsed: ") + choice.refusal
                                 : std::string(choice.refusal);
}

}  // namespace

std::optional<std::string> remove_vertex_blocker(const Connectivity& mesh, Vertex v, Keep keep) {
  return reason(choose(mesh, v, keep));
}

WeldEffect remove_vertex(Connectivity& mesh, Vertex v, Keep keep) {
  const Choice choice = choose(mesh, v, keep);
  if (choice.refusal) throw ContractViolation("remove_vertex: " + *reason(choice));
  return detail::close_edge(mesh, choice.along);
}

}  // namespace meshops
