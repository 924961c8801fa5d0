// What: finds the least double, such as a radius, for which a monotone predicate is true; rounds up to a double.
// Cost: a few calls of the predicate if the estimate is near the result; some sixty without an estimate.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rbpa {

/// Returns the least double that is not below `value`, for value ≥ 0.
inline double rounded_up(long double value) {
  const auto nearest = static_cast<double>(value);
  return nearest < value ? std::nextafter(nearest, std::numeric_limits<double>::infinity()) : nearest;
}

/// Returns the least double above `below` for which reaches() is true. Calls reaches() for doubles between `below` and
/// `reached` only. Requires: 0 ≤ below < reached; reaches() is true for `reached` and, if true for a double, for all
/// greater ones.
template <typename Reaches>
double least_reaching_between(double below, double reached, const Reaches& reaches) {
  // Positive doubles are ordered like their bits.
  auto low = std::bit_cast<std::uint64_t>(below), high = std::bit_cast<std::uint64_t>(reached);
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (reaches(std::bit_cast<double>(middle)) ? high : low) = middle;
  }
  return std::bit_cast<double>(high);
}

/// Returns the least positive double for which reaches() is true; infinity if it is true for no finite double. An
/// estimate that is not positive and finite is ignored.
/// Requires: if reaches() is true for a double, it is true for all greater ones.
template <typename Reaches>
double least_reaching(double estimate, const Reaches& reaches) {
  constexpr double greatest = std::numeric_limits<double>::max();
  const auto reaches_bits = [&](std::uint64_t bits) { return reaches(std::bit_cast<double>(bits)); };
  std::uint64_t below = 0, above = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  if (estimate > 0 && estimate <= greatest) {
    // Bracket the result from the estimate in growing steps.
    const auto start = std::bit_cast<std::uint64_t>(estimate);
    const bool is_reached = reaches_bits(start);
    (is_reached ? above : below) = start;
    for (std::uint64_t step = 1; above - below > step; step *= 4) {
      const std::uint64_t next = is_reached ? start - std::min(step, start - 1) : std::min(start + step, above);
      if (next == above || next == below) break;
      const bool is_next_reached = reaches_bits(next);
      (is_next_reached ? above : below) = next;
      if (is_next_reached != is_reached) break;
    }
  }
  return least_reaching_between(std::bit_cast<double>(below), std::bit_cast<double>(above), reaches);
}

}  // namespace rbpa
