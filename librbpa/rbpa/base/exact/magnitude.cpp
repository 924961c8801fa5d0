#include "rbpa/base/exact/magnitude.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rbpa/base/exact/two.h"

namespace rbpa {

Magnitude magnitude(std::span<const Point> points) {
  constexpr int none_low = std::numeric_limits<int>::max(), none_high = std::numeric_limits<int>::min();
  int lowest = none_low, highest = none_high;
  const auto look = [&](double coordinate) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(coordinate);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const int exponent = static_cast<int>((bits >> 52) & 0x7ff);
    if (exponent == 0 && fraction == 0) return;
    const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
    const int unit = std::max(exponent, 1) - 1075;  // the coordinate is mantissa · 2^unit
    lowest = std::min(lowest, unit + std::countr_zero(mantissa));
    highest = std::max(highest, unit + static_cast<int>(std::bit_width(mantissa)));
  };
  for (const Point& p : points) {
    look(p.x);
    look(p.y);
  }
  if (lowest == none_low) return {};
  return {lowest, highest};
}

Magnitude magnitude_bound(std::span<const Point> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Two<double> zero = {};
  Two<double> least = {infinity, infinity}, greatest = {};
  for (const Point& p : points) {
    const Two<double> size = magnitudes(std::bit_cast<Two<double>>(p));
    greatest = size > greatest ? size : greatest;
    least = ((size < least) & (size > zero)) ? size : least;
  }
  const double low = std::min(least[0], least[1]), high = std::max(greatest[0], greatest[1]);
  if (high == 0) return {};
  constexpr int bits = std::numeric_limits<double>::digits, least_bit = -1074;
  return {std::max(std::ilogb(low) - (bits - 1), least_bit), std::ilogb(high) + 1};
}

}  // namespace rbpa
