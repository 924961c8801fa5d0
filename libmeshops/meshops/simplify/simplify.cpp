#include "meshops/simplify/simplify.h"

#include "meshops/core/live_range.h"
#include "meshops/stellar/relink.h"

namespace meshops {

std::optional<Blocker> simplify_blocker(const Connectivity& mesh) {
  if (const auto reason = detail::status_blocker(mesh)) return reason;
  for (const Face f : live_faces(mesh))
    if (!detail::is_triangle(mesh, mesh.halfedge_handle(f))) return Blocker(BlockerKind::not_triangle, f);
  return std::nullopt;
}

namespace detail {

void violate_number(const char* what, Edge e, double number, const char* expected) {
  throw ContractViolation(std::string("simplify: the policy's ") + what + " of edge " + std::to_string(e.idx()) +
                          " is " + std::to_string(number) + "; expected " + expected);
}

}  // namespace detail
}  // namespace meshops
