// Measures hrbpa() against rbpa(), CGAL and the paper's RBPA, and the effect of the leaf capacity
// (docs/explanation/plane.md, section 17).
//   bench_hierarchy [--runs=N] [--points=N]      5 runs of each in turn, on 1,000,000 points
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/contest.h"
#include "bench/machine.h"
#include "bench/timings.h"
#include "bench/workload.h"
#include "rbpa/hrbpa.h"

namespace rbpa_bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Measures each contestant on the same points, in turn, in units of `unit` seconds.
std::vector<Timings> contest(const rbpa_test::Points& points, double alpha, const std::vector<Contestant>& contestants,
                             int runs, double unit) {
  std::vector<Timings> timings(contestants.size());
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < contestants.size(); ++i)
      timings[i].of.push_back(contestants[i].run(points, alpha, nullptr).seconds / unit);
  return timings;
}

double taking_part(const rbpa::Hierarchy& hierarchy) {
  auto sum = static_cast<double>(hierarchy.looked_in_vain);
  for (const rbpa::Level& level : hierarchy.levels) sum += static_cast<double>(level.taking_part);
  return sum;
}

void against_cgal(std::size_t count, int runs) {
  std::printf("Alpha = ∞. Nanoseconds a point: median (min–max).\n\n");
  std::printf("| points | number | hrbpa | rbpa | CGAL | hrbpa / CGAL | rbpa / CGAL | levels | Σ taking part / n |\n");
  std::printf("|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar}) {
    const rbpa_test::Points points = workload.make(count);
    const auto size = static_cast<double>(points.size());
    const auto times = contest(points, infinity, {hrbpa, rbpa_with(1), cgal_indices}, runs, 1e-9 * size);
    const rbpa::Hierarchy hierarchy = rbpa::hrbpa(points, infinity);
    std::printf("| %s | %zu | %s | %s | %s | %.2f | %.2f | %zu | %.2f |\n", workload.name.c_str(), points.size(),
                times[0].text().c_str(), times[1].text().c_str(), times[2].text().c_str(),
                times[0].median() / times[2].median(), times[1].median() / times[2].median(), hierarchy.levels.size(),
                taking_part(hierarchy) / size);
    std::fflush(stdout);
  }
}

/// Measures figure 9: at twice α₀, and with strongly varying spacing.
void against_the_paper(int runs) {
  std::printf("\nMilliseconds: median (min–max).\n\n");
  std::printf(
      "| points | number | alpha | hrbpa | the paper's HRBPA | the paper's RBPA | ratio "
      "|\n|---|--:|--:|--:|--:|--:|--:|\n");
  const auto row = [&](const std::string& what, const rbpa_test::Points& points, double alpha, std::size_t capacity) {
    Timings ours, paper_levels, paper;
    for (int run = 0; run < runs; ++run) {
      ours.of.push_back(1e3 * run_hrbpa_with(points, alpha, capacity).seconds);
      paper_levels.of.push_back(1e3 * run_paper_hrbpa(points, alpha).seconds);
      paper.of.push_back(1e3 * run_paper_rbpa(points, alpha).seconds);
    }
    std::printf("| %s | %zu | %.4g | %s | %s | %s | %.1f |\n", what.c_str(), points.size(), alpha, ours.text(2).c_str(),
                paper_levels.text(2).c_str(), paper.text(2).c_str(), paper.median() / ours.median());
    std::fflush(stdout);
  };
  const rbpa_test::Points two_scales = two_level_sampling(700);
  const std::size_t few = 8;
  const double least = rbpa::hrbpa(two_scales, infinity, {.leaf_capacity = few, .progress = {}}).least_radius;
  row("two scales, as figure 9", two_scales, 2 * least, few);
  row("two scales, default leaves", two_scales, 2 * least, usual_leaves);
  row(decades.name, decades.make(20000), 100, usual_leaves);
}

/// Measures points with a pair at a distance of 10⁻¹² spacings.
void close_pair(std::size_t count, int runs) {
  const rbpa_test::Points points = uniform.make(count);
  rbpa_test::Points with_pair = points;
  with_pair.push_back({points[count / 2].x, std::nextafter(points[count / 2].y, infinity)});
  Timings without, with;
  for (int run = 0; run < runs; ++run) {
    without.of.push_back(1e3 * run_hrbpa(points, infinity).seconds);
    with.of.push_back(1e3 * run_hrbpa(with_pair, infinity).seconds);
  }
  std::printf("\nOne pair at a distance of %.1g among %zu uniform points: %s ms, without it %s ms: %.2f times.\n",
              with_pair.back().y - points[count / 2].y, count, with.text().c_str(), without.text().c_str(),
              with.median() / without.median());
}

void leaf_capacities(std::size_t count, int runs) {
  const std::vector<std::size_t> capacities{4, 16, 64, 256, 1024, 4096, 16384, 65536};
  std::printf(
      "\nAlpha = ∞, %zu points, by leaf capacity. Nanoseconds a point, median; Σ taking part / n.\n\n| points |",
      count);
  for (const std::size_t k : capacities) std::printf(" %zu |", k);
  std::printf("\n|---|");
  for (std::size_t i = 0; i < capacities.size(); ++i) std::printf("--:|");
  std::printf("\n");
  for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar}) {
    const rbpa_test::Points points = workload.make(count);
    const auto size = static_cast<double>(points.size());
    std::vector<Timings> times(capacities.size());
    for (int run = 0; run < runs; ++run)
      for (std::size_t i = 0; i < capacities.size(); ++i)
        times[i].of.push_back(1e9 * run_hrbpa_with(points, infinity, capacities[i]).seconds / size);
    std::printf("| %s |", workload.name.c_str());
    for (std::size_t i = 0; i < capacities.size(); ++i)
      std::printf(" %.0f; %.2f |", times[i].median(),
                  taking_part(rbpa::hrbpa(points, infinity, {.leaf_capacity = capacities[i], .progress = {}})) / size);
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse(argc, argv);
  if (!arguments) return 2;
  std::printf("%s; one thread, %d runs of each in turn.\n\n", rbpa_bench::machine_and_build().c_str(), arguments->runs);
  rbpa_bench::against_cgal(arguments->points, arguments->runs);
  rbpa_bench::against_the_paper(arguments->runs);
  rbpa_bench::close_pair(arguments->points, arguments->runs);
  rbpa_bench::leaf_capacities(arguments->points / 4, (arguments->runs + 1) / 2);
}
