// What: makes a solid of some of the tetrahedra of a solid.
// Cost: linear; shared among threads.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Returns the solid of the tetrahedra with the ascending indices `kept`. The neighbor of tetrahedron t across from
/// corner k stays if it is in `kept` and keeps(t, k) is true. A point that loses all its tetrahedra becomes isolated.
template <typename Keeps>
Solid part_of(const Solid& solid, const std::vector<std::uint32_t>& kept, Threads& threads, const Keeps& keeps) {
  constexpr std::size_t at_a_time = 1u << 14;
  Solid part;
  part.duplicates = solid.duplicates;
  part.distinct = solid.distinct;
  constexpr std::uint8_t corner_before = 1, corner_now = 2;
  std::vector<std::uint8_t> is_corner(corner_bound<4>(solid.simplices), 0);
  const auto mark = [&](const std::array<std::uint32_t, 4>& row, std::uint8_t as) {
    for (const std::uint32_t corner : row) std::atomic_ref(is_corner[corner]).store(as, std::memory_order_relaxed);
  };
  for_each_part(threads, solid.simplices.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) mark(solid.simplices[t], corner_before);
  });
  std::vector<std::uint32_t> number(solid.neighbors.size(), Solid::none);
  part.simplices.resize(kept.size());
  for_each_part(threads, kept.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      part.simplices[i] = solid.simplices[kept[i]];
      mark(part.simplices[i], corner_now);
      if (!number.empty()) number[kept[i]] = static_cast<std::uint32_t>(i);
    }
  });
  part.neighbors.resize(number.empty() ? 0 : kept.size());
  for_each_part(threads, part.neighbors.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t beyond = solid.neighbors[kept[i]][k];
        part.neighbors[i][k] = beyond != Solid::none && keeps(kept[i], k) ? number[beyond] : Solid::none;
      }
  });
  part.isolated = solid.isolated;
  for (std::uint32_t i = 0; i < is_corner.size(); ++i)
    if (is_corner[i] == corner_before) part.isolated.push_back(i);
  std::sort(part.isolated.begin(), part.isolated.end());
  return part;
}

}  // namespace rbpa::space
