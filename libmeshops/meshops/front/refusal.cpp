#include "meshops/front/refusal.h"

#include <array>

#include "meshops/core/blocker.h"

namespace meshops {

std::string_view name(RefusalKind kind) {
  static constexpr std::array<std::string_view, 10> names = {
      "no boundary halfedge", "no such site", "corner repeated", "site closed",    "side taken",
      "no such face",         "no triangle",  "not at front",    "triangle there", "no status"};
  return names[static_cast<std::size_t>(kind)];
}

std::string describe(const Refusal& refusal) {
  const std::string site = "site " + std::to_string(refusal.site), index = std::to_string(refusal.index);
  switch (refusal.kind) {
    case RefusalKind::no_boundary_halfedge:
      return "halfedge " + index + " is not on the boundary";
    case RefusalKind::no_such_site:
      return "there is no " + site;
    case RefusalKind::corner_repeated:
      return site + " is two corners of the triangle";
    case RefusalKind::site_closed:
      return "the faces around " + site + " close";
    case RefusalKind::side_taken:
      return "a face already lies on the left of the edge from " + site + " to site " + std::to_string(refusal.to);
    case RefusalKind::no_such_face:
      return "there is no face " + index;
    case RefusalKind::no_triangle:
      return "face " + index + " is not a triangle";
    case RefusalKind::not_at_front:
      return "no side of face " + index + " is on the boundary";
    case RefusalKind::no_status:
      return describe(Blocker(BlockerKind::no_status));
    case RefusalKind::triangle_there:
      return "face " + index + " on " + site + " and site " + std::to_string(refusal.to) + " is that triangle already";
  }
  return {};
}

}  // namespace meshops
