// Measures persistence of points in space, by solid_filtration() and solid_persistence(), and by GUDHI, in turn in one
// process, one thread each.
//   bench_persistence [--points=N] [--runs=N]      1,000,000 points, the least of 3 runs; GUDHI up to 100,000 points
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bench/arguments.h"
#include "bench/machine.h"
#include "bench/memory.h"
#include "bench/persistence_gudhi.h"
#include "bench/stopwatch.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/solid/solid.h"
#include "support/random.h"
#include "support/solid_sets.h"

namespace rbpa_bench {
namespace {

using rbpa_test::Points3;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_by_gudhi = 100'000;

Points3 noisy_torus(std::size_t count, std::uint64_t seed) {
  rbpa_test::Random random(seed);
  constexpr double turn = 6.283185307179586;
  Points3 points;
  for (std::size_t i = 0; i < count; ++i) {
    const double along = turn * random.unit(), around = turn * random.unit();
    const double out = 3 + std::cos(around) + random.between(-0.1, 0.1);
    points.push_back({out * std::cos(along), out * std::sin(along), std::sin(around) + random.between(-0.1, 0.1)});
  }
  return points;
}

struct Seconds {
  double solid = infinity, radii = infinity, pairs = infinity;
};

/// Returns the least time of each part.
Seconds measure_rbpa(const Points3& points, int runs, std::array<std::size_t, 3>& pairs) {
  Seconds least;
  for (int run = 0; run < runs; ++run) {
    const Stopwatch of_solid;
    { const rbpa::Solid solid = rbpa::solid(points, infinity, {.threads = 1}); }
    const double solid = of_solid.processor_seconds();
    const Stopwatch watch;
    const rbpa::SolidFiltration filtration = rbpa::solid_filtration(points, {.threads = 1});
    const double all_radii = watch.processor_seconds();
    const std::vector<rbpa::SolidPair> found = rbpa::solid_persistence(filtration);
    const double all = watch.processor_seconds();
    pairs = {};
    for (const rbpa::SolidPair& pair : found)
      pairs[static_cast<std::size_t>(pair.dimension)] += pair.death.value_or(infinity) > pair.birth * (1 + 1e-9);
    least = {std::min(least.solid, solid), std::min(least.radii, all_radii - solid),
             std::min(least.pairs, all - all_radii)};
  }
  return least;
}

/// Compares numbers of pairs. GUDHI rounds radii of flat tetrahedra, which makes some pairs longer than nothing.
bool are_near(const std::array<std::size_t, 3>& a, const std::array<std::size_t, 3>& b) {
  for (std::size_t dimension = 0; dimension < 3; ++dimension)
    if (1000 * (std::max(a[dimension], b[dimension]) - std::min(a[dimension], b[dimension])) > a[dimension])
      return false;
  return true;
}

void measure(const std::string& name, const Points3& points, int runs) {
  std::array<std::size_t, 3> pairs{};
  const auto n = static_cast<double>(points.size());
  const auto ns = [&](double seconds) { return 1e9 * seconds / n; };
  const Seconds ours = measure_rbpa(points, runs, pairs);
  std::printf("| %s | %zu | %.0f | %.0f | %.0f |", name.c_str(), points.size(), ns(ours.solid), ns(ours.radii),
              ns(ours.pairs));
  if (points.size() > most_by_gudhi) {
    std::printf(" – | – | – |\n");
  } else {
    PersistenceRun gudhi{.pairs = {}, .complex_seconds = infinity, .pairs_seconds = infinity};
    for (int run = 0; run < runs; ++run) {
      const PersistenceRun now = persistence_by_gudhi(points);
      gudhi = {now.pairs, std::min(gudhi.complex_seconds, now.complex_seconds),
               std::min(gudhi.pairs_seconds, now.pairs_seconds)};
    }
    std::printf(" %.0f | %.0f | %.1f |%s\n", ns(gudhi.complex_seconds), ns(gudhi.pairs_seconds),
                (gudhi.complex_seconds + gudhi.pairs_seconds) / (ours.solid + ours.radii + ours.pairs),
                are_near(gudhi.pairs, pairs) ? "" : " not equal");
  }
  std::fflush(stdout);
}

void measure_all(std::size_t points, int runs) {
  std::printf(
      "| points | count | solid() | radii | pairs | GUDHI's complex | GUDHI's pairs | GUDHI / rbpa, from points |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|\n");
  std::vector<std::size_t> counts = {std::min(points, most_by_gudhi)};
  if (points > most_by_gudhi) counts.push_back(points);
  for (const std::size_t count : counts) {
    measure("uniform", rbpa_test::uniform_cube(count, 1), runs);
    measure("jittered grid", rbpa_test::jittered_cubes(count, 2), runs);
    measure("noisy torus", noisy_torus(count, 3), runs);
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse(argc, argv, {}, {.runs = 3});
  if (!arguments) return 2;
  std::printf("%s; one thread, nanoseconds of the processor a point, the least of %d runs of each in turn.\n\n",
              rbpa_bench::machine_and_build().c_str(), arguments->runs);
  rbpa_bench::keep_memory();
  rbpa_bench::measure_all(arguments->points, arguments->runs);
}
