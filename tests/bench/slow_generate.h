// What: generates the sets of slow_paths.h.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "support/generate.h"
#include "support/random.h"

namespace rbpa_bench {

using rbpa_test::Points;
using rbpa_test::Random;

/// Returns `count` points made by make(Random&).
template <typename Make>
Points scattered(std::size_t count, std::uint64_t seed, Make make) {
  Random random(seed);
  Points points;
  points.reserve(count);
  while (points.size() < count) points.push_back(make(random));
  return points;
}

/// Returns points at(t) of a curve, t uniform in [0, 1), in any order.
template <typename At>
Points along(std::size_t count, std::uint64_t seed, At at) {
  return scattered(count, seed, [&](Random& random) -> rbpa::Point { return at(random.unit()); });
}

inline rbpa::Point polar(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

inline double normal(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
  return radius * std::cos(2 * std::numbers::pi * random.unit());
}

inline Points shuffled(Points points, std::uint64_t seed) {
  Random(seed).shuffle(points);
  return points;
}

inline int columns_for(std::size_t count) {
  return static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
}

}  // namespace rbpa_bench
