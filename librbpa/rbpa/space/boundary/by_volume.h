// What: pieces of a boundary, the largest volume first.
// Law:  of equal volumes that with the least triangle is first, by coordinates: no two closed pieces have the same.
// Cost: a sort.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "rbpa/space/boundary/measures.h"

namespace rbpa::space {

/// Their numbers in that order.
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
