// Measures the data of figure 6: hrbpa(), also with leaves of 16 points, rbpa() and the paper's RBPA and HRBPA on
// uniform points at alpha = 3 mean spacings, against their number. CSV on standard output, which draw_figures draws;
// seconds are medians.
//   bench_timing [--runs=N] [--points=N] > docs/figures/paper_6_timing.csv      5 runs of each, up to 1,000,000 points
#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <vector>

#include "bench/arguments.h"
#include "bench/contest.h"
#include "bench/machine.h"
#include "bench/timings.h"
#include "bench/workload.h"

namespace rbpa_bench {
namespace {

constexpr double alpha = 3;
constexpr std::size_t fewest = 1000;

/// Leaves so small that there are several levels: with the default, the first radius is above alpha.
Contestant hrbpa_small_leaves() {
  return {"hrbpa_small_leaves", [](std::span<const rbpa::Point> points, double radius, Triangles*) {
            return run_hrbpa_with(points, radius, 16);
          }};
}

/// Returns 1, 2 and 5 times the powers of ten.
std::vector<std::size_t> sizes(std::size_t most) {
  std::vector<std::size_t> all;
  for (std::size_t power = fewest; power <= most; power *= 10)
    for (const std::size_t times : {1u, 2u, 5u})
      if (times * power <= most) all.push_back(times * power);
  return all;
}

/// Returns the number of runs: short runs are repeated more often, because they scatter more.
int runs_for(std::size_t points, int runs) {
  return runs * static_cast<int>(std::clamp<std::size_t>(20000 / points, 1, 10));
}

void print_head(int runs) {
  std::printf("# %s; %s; %s; %s %s; one thread, median of %d runs or more\n", today().c_str(), processor().c_str(),
              memory().c_str(), compiler().c_str(), compiler_flags().c_str(), runs);
  std::printf("# uniform points, alpha = %g mean spacings; seconds from points in memory to the mesh\n", alpha);
  std::printf("points,triangles,hrbpa,hrbpa_small_leaves,rbpa,paper,paper_hrbpa\n");
}

/// Prints one row. Returns: false when the contestants disagree.
bool print_row(std::size_t count, int runs) {
  const rbpa_test::Points points = uniform.make(count);
  const std::array contestants{hrbpa, hrbpa_small_leaves(), rbpa_with(1), paper_rbpa, paper_hrbpa};
  std::array<Timings, contestants.size()> times;
  std::vector<std::size_t> triangles;
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const Run one = contestants[i].run(points, alpha, nullptr);
      times[i].of.push_back(one.seconds);
      triangles.push_back(one.triangles);
    }
  std::printf("%zu,%zu", points.size(), triangles.front());
  for (const Timings& of_one : times) std::printf(",%.4g", of_one.median());
  std::printf("\n");
  std::fflush(stdout);
  return std::all_of(triangles.begin(), triangles.end(), [&](std::size_t t) { return t == triangles.front(); });
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse(argc, argv);
  if (!arguments) return 2;
  rbpa_bench::print_head(arguments->runs);
  for (const std::size_t count : rbpa_bench::sizes(arguments->points))
    if (!rbpa_bench::print_row(count, rbpa_bench::runs_for(count, arguments->runs))) {
      std::fprintf(stderr, "bench_timing: the contestants differ in their triangles on %zu points\n", count);
      return 1;
    }
  return 0;
}
