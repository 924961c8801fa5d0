// Measures small sets one after the other in one process, beside CGAL; the first call of a process; many groups in one
// call.
//   bench_small [--runs=N] [--points=N]      9 rounds; 200,000 points in each size, 30 times as many in groups
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/cold.h"
#include "bench/contest.h"
#include "bench/machine.h"
#include "bench/memory.h"
#include "bench/stopwatch.h"
#include "bench/tables.h"
#include "bench/timings.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/groups.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/smallest_covering_alpha.h"
#include "support/random.h"

namespace rbpa_bench {
namespace {

using rbpa_test::Points;
using rbpa_test::Random;

constexpr std::array<std::size_t, 8> sizes = {3, 10, 30, 100, 300, 1000, 3000, 10000};
constexpr std::size_t points_of_a_group = 60;

/// Kind of small set. Each call makes another set, so that no branch is predicted from the run before.
struct Kind {
  std::string name;
  Points (*make)(std::size_t count, Random& random);
};

Points uniform_set(std::size_t count, Random& random) {
  Points points(count);
  for (rbpa::Point& p : points) p = {random.unit(), random.unit()};
  return points;
}

/// Returns the first points of the smallest square grid with enough points, in any order.
Points grid_set(std::size_t count, Random& random) {
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  Points points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = {static_cast<double>(i % side), static_cast<double>(i / side)};
  random.shuffle(points);
  return points;
}

/// Returns five clusters, the widest a thousand times as wide as the narrowest.
Points clusters_set(std::size_t count, Random& random) {
  Points points(count);
  std::array<rbpa::Point, 5> centers;
  for (rbpa::Point& center : centers) center = {random.unit(), random.unit()};
  for (rbpa::Point& p : points) {
    const auto cluster = static_cast<std::size_t>(random.below(5));
    const double radius = 0.1 * std::pow(1000, -0.25 * static_cast<double>(cluster)) * std::sqrt(random.unit());
    const double angle = random.between(0, 2 * std::numbers::pi);
    p = {centers[cluster].x + radius * std::cos(angle), centers[cluster].y + radius * std::sin(angle)};
  }
  return points;
}

/// Returns points of one circle, except for rounding.
Points circle_set(std::size_t count, Random& random) {
  Points points(count);
  for (rbpa::Point& p : points) {
    const double angle = random.between(0, 2 * std::numbers::pi);
    p = {std::cos(angle), std::sin(angle)};
  }
  return points;
}

const std::array<Kind, 4> kinds = {
    {{"uniform", uniform_set}, {"grid", grid_set}, {"clusters", clusters_set}, {"circle", circle_set}}};

const std::vector<Contestant>& contestants() {
  static const std::vector<Contestant> all = {arrays_with(1), cgal_indices, cgal_points};
  return all;
}
enum { arrays, indices, cgal };  // indices of contestants

/// Measures nanoseconds per point of each contestant on sets of one size, all sets in turn, one round each.
std::vector<Timings> measure_size(const Kind& kind, std::size_t size, std::size_t points, int rounds) {
  Random random(size);
  std::vector<Points> sets;
  for (std::size_t made = 0; made < points; made += size) sets.push_back(kind.make(size, random));
  std::vector<Timings> of(contestants().size());
  for (int round = -1; round < rounds; ++round)  // the first round does not count
    for (std::size_t c = 0; c < of.size(); ++c) {
      double seconds = 0;
      for (const Points& set : sets) seconds += contestants()[c].run(set, INFINITY, nullptr).seconds;
      if (round >= 0) of[c].of.push_back(1e9 * seconds / static_cast<double>(size * sets.size()));
    }
  return of;
}

void by_size(const Arguments& with, std::vector<Target>& all) {
  std::printf("Nanoseconds a point, lower quartile: how many times as fast as CGAL with indices, and as without.\n\n");
  std::printf("| points | number | arrays | CGAL indices | CGAL points | indices / arrays | points / arrays |\n");
  std::printf("|---|--:|--:|--:|--:|--:|--:|\n");
  for (const Kind& kind : kinds)
    for (const std::size_t size : sizes) {
      const std::vector<Timings> of = measure_size(kind, size, with.points, with.runs);
      const double ours = of[arrays].lower_quartile(), ratio = of[indices].lower_quartile() / ours;
      std::printf("| %s | %zu | %.0f | %.0f | %.0f | %.2f× | %.2f× |\n", kind.name.c_str(), size, ours,
                  of[indices].lower_quartile(), of[cgal].lower_quartile(), ratio, of[cgal].lower_quartile() / ours);
      std::fflush(stdout);
      const bool is_large_uniform = kind.name == "uniform" && size >= 300;
      all.push_back({kind.name + ", " + std::to_string(size) + ": CGAL indices / arrays", Sense::at_least,
                     is_large_uniform ? 1.3 : 1, ratio});
    }
}

void first_calls(int runs, std::vector<Target>& all) {
  const auto number = [](const std::string& name) {
    for (std::size_t i = 0; i < cold_contestants().size(); ++i)
      if (cold_contestants()[i].name == name) return i;
    throw std::runtime_error("no contestant is called " + name);
  };
  std::printf("\nThe first call of a process, microseconds: lower quartile (median).\n\n");
  std::printf("| points | number | arrays | CGAL points |\n|---|--:|--:|--:|\n");
  for (const Kind& kind : {kinds[0], kinds[1]})
    for (const std::size_t size : {std::size_t{100}, std::size_t{1000}, std::size_t{10000}}) {
      Random random(size);
      const PointsFile file(kind.make(size, random));
      Timings ours, cgals;
      for (int run = 0; run < 2 * runs; ++run) {
        ours.of.push_back(1e6 * run_cold("/proc/self/exe", number("arrays"), file.path()).seconds);
        cgals.of.push_back(1e6 * run_cold("/proc/self/exe", number("CGAL points"), file.path()).seconds);
      }
      std::printf("| %s | %zu | %.0f (%.0f) | %.0f (%.0f) |\n", kind.name.c_str(), size, ours.lower_quartile(),
                  ours.median(), cgals.lower_quartile(), cgals.median());
      if (size == 100)
        all.push_back(
            {kind.name + ", 100: microseconds of the first call", Sense::at_most, 150, ours.lower_quartile()});
    }
}

/// Computes each group by a separate call, as a user does without groups.h. Returns: the sum of the areas.
double one_call_each(std::span<const rbpa::Point> points, const rbpa::Groups& groups) {
  double area = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Points own;
    for (const std::uint32_t i : groups[g]) own.push_back(points[i]);
    const rbpa::Delaunay delaunay(own, {.threads = 1});
    const std::optional<double> alpha =
        rbpa::smallest_covering(delaunay, rbpa::filtration(delaunay), {.share = 1, .max_components = 1});
    const rbpa::AlphaComplex complex = rbpa::alpha_complex(own, alpha.value(), {.neighbors = true, .threads = 1});
    area += rbpa::total(rbpa::outline_polygons(own, complex, {})).area;
  }
  return area;
}

void groups(const Arguments& with, std::vector<Target>& all) {
  const std::size_t count = 30 * with.points / points_of_a_group;
  Random random(1);
  Points points;
  for (std::size_t g = 0; g < count; ++g) {
    const rbpa::Point corner{random.between(0, 1000), random.between(0, 1000)};
    for (const rbpa::Point& p : uniform_set(points_of_a_group, random))
      points.push_back({corner.x + p.x, corner.y + p.y});
  }
  std::vector<std::uint32_t> labels(points.size());
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = static_cast<std::uint32_t>(i / points_of_a_group);
  const rbpa::Groups of_points = rbpa::groups_of(labels, count);

  // For one thread, processor time is measured, which other processes on the machine disturb less.
  const auto in_one_call = [&](const rbpa::GroupAlpha& alpha, unsigned threads) {
    rbpa::GroupShapesOptions options;
    options.threads = threads;
    const Stopwatch watch;
    const rbpa::GroupShapes shapes = rbpa::shapes_of_groups(points, of_points, alpha, options);
    const double seconds = threads == 1 ? watch.processor_seconds() : watch.seconds();
    return 1e6 * seconds / static_cast<double>(count);
  };
  const double given = 0.2;
  Timings chosen, chosen_2, fixed, fixed_2, each;
  for (int round = 0; round < std::max(3, with.runs / 3); ++round) {
    chosen.of.push_back(in_one_call({}, 1));
    chosen_2.of.push_back(in_one_call({}, 2));
    fixed.of.push_back(in_one_call({.given = std::span(&given, 1)}, 1));
    fixed_2.of.push_back(in_one_call({.given = std::span(&given, 1)}, 2));
    const Stopwatch watch;
    if (!(one_call_each(points, of_points) > 0)) throw std::runtime_error("groups: no area");
    each.of.push_back(1e6 * watch.processor_seconds() / static_cast<double>(count));
  }
  std::printf("\n%zu groups of %zu points, from points to polygons with areas; microseconds a group: median.\n\n",
              count, points_of_a_group);
  std::printf("| alpha | one thread | two threads | calls of their own, one thread |\n|---|--:|--:|--:|\n");
  std::printf("| chosen, one component | %.1f | %.1f | %.1f |\n", chosen.median(), chosen_2.median(), each.median());
  std::printf("| given | %.1f | %.1f | |\n\n", fixed.median(), fixed_2.median());
  all.push_back({"microseconds a group", Sense::at_most, 25, chosen.lower_quartile()});
  all.push_back(
      {"groups: one thread / two", Sense::at_least, 1.8, chosen.lower_quartile() / chosen_2.lower_quartile()});
}

void report(const Arguments& with) {
  std::printf("%s; %d rounds of each in turn, one thread.\n\n", machine_and_build().c_str(), with.runs);
  std::vector<Target> all;
  first_calls(with.runs, all);
  keep_memory();
  by_size(with, all);
  groups(with, all);
  print(all);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  std::size_t contestant = 0;
  if (argc == 3)
    if (const auto number = rbpa_bench::behind(argv[1], "--one=");
        number && rbpa_bench::read_number(*number, contestant))
      return rbpa_bench::one(contestant, argv[2]);
  const auto arguments = rbpa_bench::parse(argc, argv, {}, {.points = 200000, .runs = 9});
  if (!arguments) return 2;
  try {
    rbpa_bench::report(*arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
  return 0;
}
