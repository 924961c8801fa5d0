// What: point sets on which a fast path may have to be left, each with a radius and the allowed time relative to CGAL.
// Law:  a set is a function of the number of points alone; seeds are fixed.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bench/workload.h"
#include "support/generate.h"
#include "support/random.h"

namespace rbpa_bench {

using rbpa_test::Points;
using rbpa_test::Random;

/// Point set, radius, and the bound on the time of the complex, in multiples of CGAL's Delaunay triangulation of the
/// points.
struct SlowPath {
  std::string kind;
  Workload workload;
  std::string alpha_text;
  double (*alpha)(const Points& points);  ///< null: no radius
  double max_rbpa, max_hrbpa;
};

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

/// List to which sets are added, of one kind after another.
struct SlowPaths {
  std::vector<SlowPath> list = {};
  std::string kind = {};
  double max_rbpa = 1.2, max_hrbpa = 1.4;

  /// Adds make(count).
  template <typename Make>
  void add(const char* name, Make make, const char* alpha_text = "∞", double (*alpha)(const Points&) = nullptr) {
    list.push_back({kind, {name, make}, alpha_text, alpha, max_rbpa, max_hrbpa});
  }
  /// Adds along().
  template <typename At>
  void curve(const char* name, std::uint64_t seed, At at) {
    add(name, [=](std::size_t n) { return along(n, seed, at); });
  }
  /// Adds scattered().
  template <typename Make>
  void each(const char* name, std::uint64_t seed, Make make) {
    add(name, [=](std::size_t n) { return scattered(n, seed, make); });
  }
};

/// Returns curves, dust, lines, crowds, duplicates, grids and exponents.
std::vector<SlowPath> slow_paths();

/// Add the parts of this list.
void add_slow_curves(SlowPaths& all);
void add_slow_dust(SlowPaths& all);
void add_slow_rows(SlowPaths& all);

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
