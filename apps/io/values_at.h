// What: selects values by a list of indices, and replaces indices by new numbers.
#pragma once

#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

namespace rbpa::app {

/// Returns values[i] for each i of `items`; empty if `values` is empty, that is, unknown.
template <std::ranges::random_access_range Values>
std::vector<std::ranges::range_value_t<Values>> values_at(const Values& values, std::span<const std::uint32_t> items) {
  std::vector<std::ranges::range_value_t<Values>> result;
  if (std::ranges::empty(values)) return result;
  result.reserve(items.size());
  for (const std::uint32_t i : items) result.push_back(values[i]);
  return result;
}

/// Return items with number[i] in place of i; unchanged items if `number` is empty. An item may be an array of indices.
inline std::uint32_t renumbered(std::uint32_t item, std::span<const std::uint32_t> number) {
  return number.empty() ? item : number[item];
}
template <std::ranges::input_range Items>
std::vector<std::ranges::range_value_t<Items>> renumbered(const Items& items, std::span<const std::uint32_t> number) {
  std::vector<std::ranges::range_value_t<Items>> result(items.begin(), items.end());
  for (auto& item : result)
    if constexpr (requires { item.begin(); })
      for (std::uint32_t& corner : item) corner = renumbered(corner, number);
    else
      item = renumbered(item, number);
  return result;
}

}  // namespace rbpa::app
