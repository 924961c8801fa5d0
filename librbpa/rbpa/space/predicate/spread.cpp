#include "rbpa/space/predicate/spread.h"

#include <algorithm>

#include "rbpa/base/exact/magnitude.h"

namespace rbpa::space {

Spread spread(std::span<const Point3> points, std::span<const double> radii) {
  NarrowestSpan narrowest;
  for (const Point3& p : points)
    for (const double coordinate : {p.x, p.y, p.z}) narrowest.include(coordinate);
  for (const double radius : radii) narrowest.include(radius);
  const auto [lowest, highest] = narrowest.span();
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
