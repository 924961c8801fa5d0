#include "meshops/stellar/collapse.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

const char* collapse_refusal(const Connectivity& mesh, Halfedge h, Keep keep) {
  if (const char* reason = detail::status_refusal(mesh)) return reason;
  return is_live(mesh, h) ? detail::close_refusal(mesh, h, keep) : "the halfedge does not exist or is deleted";
}

}  // namespace

std::optional<std::string> collapse_blocker(const Connectivity& mesh, Halfedge h, Keep keep) {
  return detail::as_blocker(collapse_refusal(mesh, h, keep));
}

WeldEffect collapse(Connectivity& mesh, Halfedge h, Keep keep) {
  detail::enforce("collapse", collapse_refusal(mesh, h, keep));
  return detail::close_edge(mesh, h);
}

}  // namespace meshops
