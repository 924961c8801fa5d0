// What: at which edges of a boundary several wedges of tetrahedra meet.
// Cost: linear, and a sort of the few sides at each point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rbpa/base/triangle_arrays.h"

namespace rbpa::space {

/// A side of a triangle, across from a corner.
struct TriangleSide {
  std::uint32_t triangle, across;
};

/// Calls visit(first, last) for the sides at each edge that leave its lower point, where there is more than one: [first, last) are
/// iterators over pairs of the higher point and the TriangleSide, by number.
/// Requires: triangles whose corners are below `points`, each edge being on as many of them in one direction as in the other.
template <typename Visit>
void for_each_shared_edge(const std::vector<Triangle>& triangles, std::size_t points, const Visit& visit) {
  std::vector<std::uint32_t> end(points + 1, 0);  // of the sides that leave each point upward
  const auto for_each_side = [&](const auto& put) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triangles[t][(k + 1) % 3], to = triangles[t][(k + 2) % 3];
        if (from < to) put(from, to, TriangleSide{t, k});
      }
  };
  for_each_side([&](std::uint32_t from, std::uint32_t, const TriangleSide&) { ++end[from + 1]; });
  for (std::size_t i = 1; i <= points; ++i) end[i] += end[i - 1];
  std::vector<std::pair<std::uint32_t, TriangleSide>> sides(end.back());
  for_each_side([&](std::uint32_t from, std::uint32_t to, const TriangleSide& side) {
    sides[end[from]++] = {to, side};
  });
  // end[i] is now the end of i's, and that of the one before is where they begin.
  for (std::size_t i = 0, begin = 0; i < points; begin = end[i++]) {
    const auto first = sides.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = sides.begin() + static_cast<std::ptrdiff_t>(end[i]);
    std::sort(first, last, [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second.triangle < b.second.triangle;
    });
    for (auto at = first; at != last;) {
      auto next = at + 1;
      while (next != last && next->first == at->first) ++next;
      if (next - at > 1) visit(at, next);
      at = next;
    }
  }
}

}  // namespace rbpa::space
