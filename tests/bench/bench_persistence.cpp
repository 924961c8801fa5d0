// Measures persistence of points in space, by solid_filtration() and solid_persistence(), and by GUDHI, in turn in one
// process, one thread each.
//   bench_persistence [--points=N] [--runs=N]      1,000,000 points, the least of 3 runs; GUDHI up to 100,000 points
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bench/options.h"
#include "bench/peers.h"
#include "bench/process.h"
#include "bench/tables.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/solid/solid.h"
#include "support/random.h"
#include "support/solid_sets.h"

namespace rbpa_bench {
namespace {

using rbpa_test::Points3;
constexpr std::size_t most_by_gudhi = 100'000;

Points3 noisy_torus(std::size_t count, std::uint64_t seed) {
  rbpa_test::Random random(seed);
  constexpr double turn = 2 * std::numbers::pi;
  Points3 points;
  for (std::size_t i = 0; i < count; ++i) {
    const double along = turn * random.unit(), around = turn * random.unit();
    const double out = 3 + std::cos(around) + random.between(-0.1, 0.1);
    points.push_back({out * std::cos(along), out * std::sin(along), std::sin(around) + random.between(-0.1, 0.1)});
  }
  return points;
}

/// Returns for each dimension the number of pairs that last longer than rounding.
std::array<std::size_t, 3> lasting(const std::vector<rbpa::SolidPair>& found) {
  std::array<std::size_t, 3> pairs{};
  for (const rbpa::SolidPair& pair : found)
    pairs[static_cast<std::size_t>(pair.dimension)] += pair.death.value_or(INFINITY) > pair.birth * (1 + 1e-9);
  return pairs;
}

/// Compares numbers of pairs. GUDHI rounds radii of flat tetrahedra, which makes some pairs longer than nothing.
bool are_near(const std::array<std::size_t, 3>& a, const std::array<std::size_t, 3>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](std::size_t one, std::size_t other) {
    return 1000 * (std::max(one, other) - std::min(one, other)) <= one;
  });
}

void measure(const std::string& name, const Points3& points, int runs) {
  rbpa::SolidFiltration filtration;
  std::vector<rbpa::SolidPair> pairs;
  PersistenceRun gudhi;
  Timings of_complex;
  const auto timed = [](auto step) {
    const Stopwatch watch;
    step();
    return watch.run(0);
  };
  std::vector<Contestant> contestants = {
      {"solid",
       [&] { return timed([&] { const rbpa::Solid solid = rbpa::solid(points, INFINITY, {.threads = 1}); }); }},
      {"radii",
       [&] {
         filtration = {};
         return timed([&] { filtration = rbpa::solid_filtration(points, {.threads = 1}); });
       }},
      {"pairs",
       [&] {
         pairs = {};
         return timed([&] { pairs = rbpa::solid_persistence(filtration); });
       }},
      {"GUDHI", [&] {
         gudhi = persistence_by_gudhi(points);
         of_complex.of.push_back(gudhi.complex.processor_seconds);
         return gudhi.all;
       }}};
  if (points.size() > most_by_gudhi) contestants.pop_back();
  const std::vector<Outcome> of = in_turn(contestants, {.runs = runs, .by_processor = true});
  const auto ns = [&](double seconds) { return text("%.0f", 1e9 * seconds / static_cast<double>(points.size())); };
  const double solid = of[0].seconds.least(), radii = of[1].seconds.least(), paired = of[2].seconds.least();
  std::vector<std::string> cells = {
      name, text("%zu", points.size()), ns(solid), ns(radii - solid), ns(paired), "–", "–", "–"};
  if (of.size() > 3) {
    const double all = of[3].seconds.least();
    cells[5] = ns(of_complex.least());
    cells[6] = ns(all - of_complex.least());
    cells[7] = text("%.1f", all / (radii + paired)) + (are_near(gudhi.pairs, lasting(pairs)) ? "" : " not equal");
  }
  print_row(cells);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const auto [points, runs] = read_sizes(argc, argv, {.runs = 3});
  std::printf("%s; one thread, nanoseconds of the processor a point, the least of %d runs of each in turn.\n\n",
              machine().c_str(), runs);
  keep_memory();
  print_head({"points"},
             {"count", "solid()", "radii", "pairs", "GUDHI's complex", "GUDHI's pairs", "GUDHI / rbpa, from points"});
  std::vector<std::size_t> counts = {std::min(points, most_by_gudhi)};
  if (points > most_by_gudhi) counts.push_back(points);
  for (const std::size_t count : counts) {
    measure("uniform", rbpa_test::uniform_cube(count, 1), runs);
    measure("jittered grid", rbpa_test::jittered_cubes(count, 2), runs);
    measure("noisy torus", noisy_torus(count, 3), runs);
  }
}
