#include "meshops/stellar/collapse.h"

#include "meshops/stellar/relink.h"

namespace meshops {
std::optional<Blocker> collapse_blocker(const Connectivity& mesh, Halfedge h, Keep keep) {
  if (const auto reason = detail::status_blocker(mesh)) return reason;
  return is_live(mesh, h) ? detail::close_blocker(mesh, h, keep) : Blocker(BlockerKind::missing, h);
}

WeldEffect collapse(Connectivity& mesh, Halfedge h, Keep keep) {
  detail::enforce("collapse", collapse_blocker(mesh, h, keep));
  return detail::close_edge(mesh, h);
}

std::variant<WeldEffect, Blocker> try_collapse(Connectivity& mesh, Halfedge h, Keep keep) {
  if (const auto blocker = collapse_blocker(mesh, h, keep)) return *blocker;
  return detail::close_edge(mesh, h);
}

}  // namespace meshops
