#include "rbpa/base/exact/magnitude.h"

#include <cmath>

#include "rbpa/base/exact/two.h"

namespace rbpa {

Magnitude magnitude(std::span<const Point> points) {
  NarrowestSpan narrowest;
  for (const Point& p : points) {
    narrowest.include(p.x);
    narrowest.include(p.y);
  }
  return narrowest.span();
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
