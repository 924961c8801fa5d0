// What: simplices of one dimension in the order of a filtration: by alpha, then by number.
// Cost: a sort.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/steps.h"

namespace rbpa::space {

/// Their numbers.
inline std::vector<std::uint32_t> sorted_by_alpha(std::span<const double> alpha, Steps& step) {
  // Radii are at least 0, so that they are in the order of their bits.
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(alpha.size());
  for (std::uint32_t i = 0; i < keyed.size(); ++i) keyed[i] = {std::bit_cast<std::uint64_t>(alpha[i]), i};
  sort(keyed, step, [](const auto& a, const auto& b) { return a < b; });
  std::vector<std::uint32_t> order(keyed.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].second;
  return order;
}

}  // namespace rbpa::space
