// What: sorts the pieces of a boundary by absolute volume, the largest first.
// Law:  among pieces of equal volume, the piece with the lexicographically least triangle is first. There are no ties,
//       because no two closed pieces share a triangle.
// Cost: a sort.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "rbpa/space/solid/boundary/measures.h"

namespace rbpa::space {

/// Returns the indices of `pieces`, sorted by descending absolute volume.
inline std::vector<std::uint32_t> by_volume(const std::vector<ClosedMeasures>& pieces) {
  std::vector<std::uint32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const double volume = std::abs(pieces[i].volume), other = std::abs(pieces[j].volume);
    return volume != other ? volume > other : pieces[i].least < pieces[j].least;
  });
  return order;
}

}  // namespace rbpa::space
