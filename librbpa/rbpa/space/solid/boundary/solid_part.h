// What: makes a solid of some of the tetrahedra of a solid.
// Cost: linear.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Returns the solid of the tetrahedra with the ascending indices `kept`. The neighbor of tetrahedron t across from
/// corner k stays if it is in `kept` and keeps(t, k) is true. A point that loses all its tetrahedra becomes isolated.
template <typename Keeps>
Solid part_of(const Solid& solid, const std::vector<std::uint32_t>& kept, const Keeps& keeps) {
  Solid part;
  part.duplicates = solid.duplicates;
  part.distinct = solid.distinct;
  constexpr std::uint8_t corner_before = 1, corner_now = 2;
  std::vector<std::uint8_t> is_corner(corner_bound<4>(solid.simplices), 0);
  for (const auto& row : solid.simplices)
    for (const std::uint32_t corner : row) is_corner[corner] = corner_before;
  part.simplices.reserve(kept.size());
  for (const std::uint32_t t : kept) {
    part.simplices.push_back(solid.simplices[t]);
    for (const std::uint32_t corner : solid.simplices[t]) is_corner[corner] = corner_now;
  }
  if (!solid.neighbors.empty()) {
    std::vector<std::uint32_t> number(solid.simplices.size(), Solid::none);
    for (std::size_t i = 0; i < kept.size(); ++i) number[kept[i]] = static_cast<std::uint32_t>(i);
    part.neighbors.reserve(kept.size());
    for (const std::uint32_t t : kept) {
      std::array<std::uint32_t, 4> row = solid.neighbors[t];
      for (std::size_t k = 0; k < 4; ++k)
        if (row[k] != Solid::none) row[k] = keeps(t, k) ? number[row[k]] : Solid::none;
      part.neighbors.push_back(row);
    }
  }
  part.isolated = solid.isolated;
  for (std::uint32_t i = 0; i < is_corner.size(); ++i)
    if (is_corner[i] == corner_before) part.isolated.push_back(i);
  std::sort(part.isolated.begin(), part.isolated.end());
  return part;
}

}  // namespace rbpa::space
