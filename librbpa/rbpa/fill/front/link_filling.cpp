#include "rbpa/fill/front/link_filling.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace rbpa {
namespace {

/// A side of a triangle, with its edge and its group.
struct GroupSide {
  std::uint64_t edge;  // the lesser end in the high 32 bits, the greater end in the low
  std::size_t group;
  std::uint32_t triangle;
  std::uint8_t across;  // the number of the corner across, 0 to 2
  bool ascends;
  friend bool operator<(const GroupSide& a, const GroupSide& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.group < b.group;
  }
};

std::vector<GroupSide> sorted_sides(const Filling& filling, Steps& step) {
  std::vector<GroupSide> sides;
  sides.reserve(3 * filling.triangles.size());
  for (std::uint32_t t = 0; t < filling.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = filling.triangles[t][(k + 1) % 3], to = filling.triangles[t][(k + 2) % 3];
      const std::uint64_t low = std::min(from, to), high = std::max(from, to);
      sides.push_back({low << 32 | high, filling.groups[t], t, static_cast<std::uint8_t>(k), from < to});
    }
  sort(sides, step, std::less<>());
  return sides;
}

/// Calls visit(first, last) for each edge, with the range of its sides in `sides`.
template <typename Visit>
void for_each_shared_edge(const std::vector<GroupSide>& sides, Visit visit) {
  for (auto first = sides.begin(); first != sides.end();) {
    auto last = first + 1;
    while (last != sides.end() && last->edge == first->edge) ++last;
    visit(first, last);
    first = last;
  }
}

/// Returns for each group whether it overlaps another group at an edge: both have triangles on one side of the edge.
/// The triangles of an overlapping group get neighbors in their own group only.
std::vector<bool> are_apart(const std::vector<GroupSide>& sides, Steps& step) {
  std::size_t groups = 0;
  for (const GroupSide& side : sides) groups = std::max(groups, side.group + 1);
  std::vector<bool> apart(groups, false);
  for_each_shared_edge(sides, [&](auto first, auto last) {
    step();
    for (const bool ascends : {false, true}) {
      const auto is_one = [&](const GroupSide& side) { return side.ascends == ascends; };
      if (std::count_if(first, last, is_one) < 2) continue;
      for (auto side = first; side != last; ++side)
        if (is_one(*side)) apart[side->group] = true;
    }
  });
  return apart;
}

}  // namespace

void link(Filling& filling, Steps& step) {
  const std::vector<GroupSide> sides = sorted_sides(filling, step);
  const std::vector<bool> apart = are_apart(sides, step);
  filling.neighbors.assign(filling.triangles.size(),
                           {TriangleArrays::none, TriangleArrays::none, TriangleArrays::none});
  const auto join = [&](const GroupSide& a, const GroupSide& b) {
    filling.neighbors[a.triangle][a.across] = b.triangle;
    filling.neighbors[b.triangle][b.across] = a.triangle;
  };
  for_each_shared_edge(sides, [&](auto first, auto last) {
    step();
    auto shared = last;  // the first side of the edge of a group that is not apart; the edge has at most two
    for (auto side = first; side != last; ++side) {
      if (apart[side->group]) {
        if (side != first && (side - 1)->group == side->group) join(*(side - 1), *side);
      } else if (shared == last) {
        shared = side;
      } else {
        join(*shared, *side);
      }
    }
  });
}

}  // namespace rbpa
