#include "rbpa/space/predicate/spread.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "rbpa/base/exact/magnitude.h"

namespace rbpa::space {

Spread spread(std::span<const Point3> points, std::span<const double> radii) {
  // Find the exponents of the lowest and the highest bit of all coordinates and radii.
  int lowest = 2000, highest = -2000;
  const auto look = [&](double coordinate) {
    const auto bits = std::bit_cast<std::uint64_t>(coordinate);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52U) - 1);
    const auto field = static_cast<int>(bits >> 52U & 0x7FFU);
    if (field == 0 && fraction == 0) return;
    const std::uint64_t mantissa = field == 0 ? fraction : fraction | std::uint64_t{1} << 52U;
    const int last = std::max(field, 1) - 1075;  // the coordinate is mantissa · 2^last
    lowest = std::min(lowest, last + std::countr_zero(mantissa));
    highest = std::max(highest, last + static_cast<int>(std::bit_width(mantissa)));
  };
  for (const Point3& p : points) {
    look(p.x);
    look(p.y);
    look(p.z);
  }
  for (const double radius : radii) look(radius);
  if (lowest > highest) return {};  // all values are 0
  if (fits_double({lowest, highest})) return {0, lowest, true};
  // Scale the greatest coordinate to about 1, as far as the lowest bit allows. A greater spread loses low bits.
  const int exponent = std::min(std::max(-highest, least_in_double - lowest), largest_in_double - highest);
  return {exponent, lowest + exponent, lowest + exponent >= least_in_double};
}

std::span<const Point3> scaled(std::span<const Point3> points, const Spread& spread, std::vector<Point3>& copy) {
  if (spread.exponent == 0) return points;
  copy.reserve(points.size());
  const auto scale = [&](double value) { return std::ldexp(value, spread.exponent); };
  for (const Point3& p : points) copy.push_back({scale(p.x), scale(p.y), scale(p.z)});
  return copy;
}

std::span<const double> scaled(std::span<const double> radii, const Spread& spread, std::vector<double>& copy) {
  if (spread.exponent == 0) return radii;
  copy.reserve(radii.size());
  for (const double radius : radii) copy.push_back(std::ldexp(radius, spread.exponent));
  return copy;
}

}  // namespace rbpa::space
