// Measures small sets one after the other in one process, compared with CGAL; the first call of a process; many groups
// in one call.
//   bench_small [--runs=N] [--points=N]      9 rounds; 200,000 points in each size, 30 times as many in groups
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "bench/contest.h"
#include "bench/options.h"
#include "bench/process.h"
#include "bench/tables.h"
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

/// Returns points of one circle, except for rounding.
Points circle_set(std::size_t count, Random& random) {
  Points points(count);
  for (rbpa::Point& p : points) {
    const double angle = random.between(0, 2 * std::numbers::pi);
    p = {std::cos(angle), std::sin(angle)};
  }
  return points;
}

const std::array<Kind, 3> kinds = {{{"uniform", uniform_set}, {"grid", grid_set}, {"circle", circle_set}}};

constexpr std::array<std::size_t, 8> sizes_by_size = {3, 10, 30, 100, 300, 1000, 3000, 10000};
constexpr std::array<std::size_t, 3> sizes_of_first_calls = {100, 1000, 10000};

/// Measures all sets of one size in turn, by each method.
void by_size(const Sizes& sizes) {
  std::printf("\nNanoseconds a point, lower quartile: how many times as fast as CGAL.\n\n");
  print_head({"points"}, {"number", "arrays", "CGAL points", "points / arrays"});
  for (const Kind& kind : kinds)
    for (const std::size_t size : sizes_by_size) {
      Random random(size);
      std::vector<Points> sets;
      for (std::size_t made = 0; made < sizes.points; made += size) sets.push_back(kind.make(size, random));
      std::vector<Contestant> contestants;
      for (const Method& method : {arrays_with(1), cgal_points()})
        contestants.push_back({method.name, [&sets, run = method.run] {
                                 Run all;
                                 for (const Points& set : sets) {
                                   const Run one = run(set, INFINITY, nullptr);
                                   all.seconds += one.seconds;
                                   all.count += one.count;
                                 }
                                 return all;
                               }});
      const auto of = in_turn(contestants, {.runs = sizes.runs, .warm = true});
      const double unit = 1e9 / static_cast<double>(size * sets.size()), ours = unit * of[0].seconds.lower_quartile(),
                   cgals = unit * of[1].seconds.lower_quartile();
      print_row({kind.name, text("%zu", size), text("%.0f", ours), text("%.0f", cgals),
                 text("%.2f×", cgals / ours) + of[1].wrong});
    }
}

void first_calls(int runs) {
  const auto number = [](const std::string& name) {
    std::size_t i = 0;
    while (cold_methods().at(i).name != name) ++i;
    return i;
  };
  std::printf("The first call of a process, microseconds: lower quartile (median).\n\n");
  print_head({"points"}, {"number", "arrays", "CGAL points"});
  for (const Kind& kind : {kinds[0], kinds[1]})
    for (const std::size_t size : sizes_of_first_calls) {
      Random random(size);
      const Folder folder;
      write_values(folder / "points", kind.make(size, random));
      std::vector<Contestant> contestants;
      for (const char* name : {"arrays", "CGAL points"})
        contestants.push_back({name, [&, i = number(name)] { return run_cold(i, folder / "points").run; }});
      std::vector<std::string> cells = {kind.name, text("%zu", size)};
      const auto of = in_turn(contestants, {.runs = 2 * runs});
      for (const Outcome& outcome : of)
        cells.push_back(text("%.0f (%.0f)", 1e6 * outcome.seconds.lower_quartile(), 1e6 * outcome.seconds.median()) +
                        outcome.failure);
      print_row(cells);
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

void groups(const Sizes& sizes) {
  constexpr std::size_t points_of_a_group = 60;
  const std::size_t count = 30 * sizes.points / points_of_a_group;
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

  const double given = 0.2;
  const auto in_one_call = [&](const rbpa::GroupAlpha& alpha, unsigned threads) {
    return [&, alpha, threads] {
      rbpa::GroupShapesOptions options;
      options.threads = threads;
      const Stopwatch watch;
      const rbpa::GroupShapes shapes = rbpa::shapes_of_groups(points, of_points, alpha, options);
      Run run = watch.run(0);
      // For one thread, processor time is measured, which other processes on the machine disturb less.
      if (threads == 1) run.seconds = run.processor_seconds;
      return run;
    };
  };
  const auto each = [&] {
    const Stopwatch watch;
    if (!(one_call_each(points, of_points) > 0)) throw std::runtime_error("groups: no area");
    return Run{watch.processor_seconds()};
  };
  const rbpa::GroupAlpha fixed{.given = std::span(&given, 1)};
  const auto of = in_turn({{"chosen", in_one_call({}, 1)},
                           {"chosen, two threads", in_one_call({}, 2)},
                           {"given", in_one_call(fixed, 1)},
                           {"given, two threads", in_one_call(fixed, 2)},
                           {"calls of their own", each}},
                          {.runs = std::max(3, sizes.runs / 3)});
  const auto a_group = [&](std::size_t i) {
    return text("%.1f", 1e6 * of[i].seconds.median() / static_cast<double>(count));
  };
  std::printf("\n%zu groups of %zu points, from points to polygons with areas; microseconds a group: median.\n\n",
              count, points_of_a_group);
  print_head({"alpha"}, {"one thread", "two threads", "calls of their own, one thread"});
  print_row({"chosen, one component", a_group(0), a_group(1), a_group(4)});
  print_row({"given", a_group(2), a_group(3), ""});
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  answer_cold_run(argc, argv);
  const Sizes sizes = read_sizes(argc, argv, {.points = 200000, .runs = 9});
  std::printf("%s; %d rounds of each in turn, one thread.\n\n", machine().c_str(), sizes.runs);
  first_calls(sizes.runs);
  keep_memory();
  by_size(sizes);
  groups(sizes);
}
