// What: formats causes with their counts as text.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>

namespace rbpa::app {

/// Returns "3 TEXT, 2 TEXT": each count above 0 with its text, the greatest count first; "" if all counts are 0.
template <std::size_t n>
std::string list_of_causes(const std::array<std::size_t, n>& counts, const std::array<const char*, n>& texts) {
  std::array<std::size_t, n> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return counts[a] > counts[b]; });
  std::string text;
  for (const std::size_t i : order) {
    if (counts[i] == 0) break;
    if (!text.empty()) text += ", ";
    text += std::to_string(counts[i]) + " " + texts[i];
  }
  return text;
}

}  // namespace rbpa::app
