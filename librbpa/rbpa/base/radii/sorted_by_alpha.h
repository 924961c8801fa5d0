// What: sorts simplices of one dimension in the order of a filtration: by alpha, then by number or volume.
// How:  non-negative doubles are ordered like their bits, negative ones in reverse. Three passes of radix sort use the
//       highest 32 bits that differ; simplices that are equal in these bits are sorted by comparisons.
// Cost: linear if few values are nearly but not exactly equal; else a sort.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/run/steps.h"

namespace rbpa {

/// Returns the numbers of the simplices, sorted by alpha, then by number. Requires: no alpha is −0 or NaN.
inline meshops::FreshVector<std::uint32_t> sorted_by_alpha(std::span<const double> alpha, Steps& step) {
  constexpr int digit_bits = 11, digits = 3, key_bits = 32;
  constexpr std::uint32_t mask = (1u << digit_bits) - 1;
  struct Keyed {
    std::uint32_t key, number;
  };
  const auto bits = [&](std::size_t i) {
    const auto own = std::bit_cast<std::uint64_t>(alpha[i]);
    return own >> 63U != 0 ? ~own : own | std::uint64_t{1} << 63U;
  };
  std::uint64_t least = ~std::uint64_t{0}, greatest = 0;
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    least = std::min(least, bits(i));
    greatest = std::max(greatest, bits(i));
  }
  const int shift = alpha.empty() ? 0 : std::max(0, static_cast<int>(std::bit_width(greatest - least)) - key_bits);
  meshops::FreshVector<Keyed> keyed(alpha.size()), other(alpha.size());
  std::array<std::array<std::uint32_t, mask + 1>, digits> place{};
  for (std::uint32_t i = 0; i < keyed.size(); ++i) {
    keyed[i] = {static_cast<std::uint32_t>((bits(i) - least) >> shift), i};
    for (int digit = 0; digit < digits; ++digit)
      ++place[static_cast<std::size_t>(digit)][keyed[i].key >> digit * digit_bits & mask];
  }
  for (int digit = 0; digit < digits; ++digit) {
    step(keyed.size() / 8);
    auto& of = place[static_cast<std::size_t>(digit)];
    std::uint32_t sum = 0;
    for (std::uint32_t& count : of) sum += std::exchange(count, sum);
    for (const Keyed& item : keyed) other[of[item.key >> digit * digit_bits & mask]++] = item;
    keyed.swap(other);
  }
  meshops::FreshVector<std::uint32_t> order(keyed.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].number;
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
    step();
    return bits(a) != bits(b) ? bits(a) < bits(b) : a < b;
  };
  for (std::size_t first = 0, last; shift > 0 && first < order.size(); first = last) {
    last = first + 1;
    while (last < order.size() && keyed[last].key == keyed[first].key) ++last;
    if (last - first > 1) std::sort(&order[first], &order[0] + last, is_before);
  }
  return order;
}

/// Sorts numbers of simplices, sorted by alpha, by volume where alpha is equal. Sums of volumes in this order do not
/// depend on the numbering.
template <typename Real>
void sort_equal_by_volume(std::span<std::uint32_t> order, std::span<const double> alpha, std::span<const Real> volumes,
                          Steps& step) {
  for (std::size_t first = 0, last; first < order.size(); first = last) {
    for (last = first + 1; last < order.size() && alpha[order[last]] == alpha[order[first]]; ++last) continue;
    if (last - first > 1)
      std::sort(&order[first], &order[0] + last, [&](std::uint32_t a, std::uint32_t b) {
        step();
        return volumes[a] < volumes[b];
      });
  }
}

}  // namespace rbpa
