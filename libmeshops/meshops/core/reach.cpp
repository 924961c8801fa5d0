#include "meshops/core/reach.h"

#include <array>
#include <unordered_set>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"

namespace meshops {
namespace {

void require_live(const Connectivity& mesh, const char* which, Face a, Face b) {
  for (const Face f : {a, b}) require(is_live(mesh, f), which, f.idx(), " does not exist or is deleted");
}

}  // namespace

bool on_same_curve(const Connectivity& mesh, Halfedge a, Halfedge b) {
  for (const Halfedge h : {a, b})
    require(is_live(mesh, h) && mesh.is_boundary(h), "on_same_curve: halfedge ", h.idx(),
            " is not a boundary halfedge");
  if (a == b) return true;
  for (Halfedge from_a = a, from_b = b;;) {
    from_a = mesh.next_halfedge_handle(from_a);
    if (from_a == b) return true;
    if (from_a == a) return false;
    from_b = mesh.next_halfedge_handle(from_b);
    if (from_b == a) return true;
    if (from_b == b) return false;
  }
}

bool in_same_component(const Connectivity& mesh, Face a, Face b, Edge without) {
  require_live(mesh, "in_same_component: face ", a, b);
  return !smaller_part(mesh, a, b, without);
}

std::optional<std::vector<Face>> smaller_part(const Connectivity& mesh, Face a, Face b, Edge without) {
  require_live(mesh, "smaller_part: face ", a, b);
  if (a == b) return std::nullopt;
  struct Search {
    std::unordered_set<int> seen;
    std::vector<Face> open;  // a breadth-first queue, so that the two searches grow toward each other
    std::size_t next = 0;
  };
  std::array<Search, 2> searches;
  searches[0] = {{a.idx()}, {a}};
  searches[1] = {{b.idx()}, {b}};
  for (std::size_t turn = 0;; turn = 1 - turn) {
    Search& mine = searches[turn];
    const Search& other = searches[1 - turn];
    if (mine.next == mine.open.size()) return std::move(mine.open);
    const Halfedge first = mesh.halfedge_handle(mine.open[mine.next++]);
    Halfedge side = first;
    do {
      const Face beyond = mesh.face_handle(mesh.opposite_halfedge_handle(side));
      if (beyond.is_valid() && mesh.edge_handle(side) != without) {
        if (other.seen.count(beyond.idx()) != 0) return std::nullopt;
        if (mine.seen.insert(beyond.idx()).second) mine.open.push_back(beyond);
      }
      side = mesh.next_halfedge_handle(side);
    } while (side != first);
  }
}

}  // namespace meshops
