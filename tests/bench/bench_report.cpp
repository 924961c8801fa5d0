// A table of rbpa() against CGAL, both run in turn on the same points, as docs/performance.md shows it.
//   bench_report [--runs=N] [--points=N]      5 runs of each, on 1,000,000 points
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "bench/arguments.h"
#include "bench/contest.h"
#include "bench/machine.h"
#include "bench/memory.h"
#include "bench/timings.h"

namespace rbpa_bench {
namespace {

struct Figures {
  Timings per_point;  ///< nanoseconds
  std::size_t triangles = 0;
  std::string bytes_per_point = "?";
};

struct Row {
  Figures ours, peer;
};

Row contest(const Workload& workload, std::size_t count, double alpha, int runs) {
  Row row;
  struct Side {
    const Contestant& contestant;
    Figures& figures;
  };
  const Side sides[] = {{rbpa_near_to_far, row.ours}, {cgal, row.peer}};
  for (const Side& side : sides) {  // first, while this process has freed little that a child could be given again
    rbpa_test::Points points;
    if (const auto bytes =
            peak_bytes([&] { points = workload.make(count); }, [&] { side.contestant.run(points, alpha); }))
      side.figures.bytes_per_point = std::to_string(std::lround(*bytes / static_cast<double>(count)));
  }
  const rbpa_test::Points points = workload.make(count);
  for (int run = 0; run < runs; ++run)
    for (const Side& side : sides) {
      const Run result = side.contestant.run(points, alpha);
      side.figures.per_point.of.push_back(1e9 * result.seconds / static_cast<double>(points.size()));
      side.figures.triangles = result.triangles;
    }
  std::printf("| %s | %zu | %s | %zu | %s | %s | %.2f | %s | %s |\n", std::string(workload.name).c_str(), points.size(),
              std::isinf(alpha) ? "∞" : std::to_string(std::lround(alpha)).c_str(), row.ours.triangles,
              row.ours.per_point.text().c_str(), row.peer.per_point.text().c_str(),
              row.ours.per_point.median() / row.peer.per_point.median(), row.ours.bytes_per_point.c_str(),
              row.peer.bytes_per_point.c_str());
  if (row.ours.triangles != row.peer.triangles)
    std::printf("\n**The triangles differ: CGAL with its rounded filter has %zu.**\n\n", row.peer.triangles);
  std::fflush(stdout);
  return row;
}

void report(std::size_t count, int runs) {
  std::printf("%s; %s; %s; %s `%s`; one thread, %d runs of each in turn.\n\n", processor().c_str(), memory().c_str(),
              system().c_str(), compiler().c_str(), compiler_flags().c_str(), runs);
  std::printf(
      "Nanoseconds a point: median (min–max). Alpha in mean spacings. Bytes: peak beyond the input, a point.\n\n");
  std::printf(
      "| points | number | alpha | triangles | rbpa, ns | CGAL and filter, ns | ratio | rbpa, bytes | CGAL, bytes |\n");
  std::printf("|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const Workload& workload : {uniform, jittered, grid}) contest(workload, count, 3, runs);
  for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar})
    contest(workload, count, INFINITY, runs);
  const double tenth = contest(uniform, count / 10, 3, runs).ours.per_point.median();
  const double fourfold = contest(uniform, count * 4, 3, runs).ours.per_point.median();
  std::printf("\nGrowth: %.2f times the time a point at %zu points compared with %zu.\n", fourfold / tenth, count * 4,
              count / 10);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse(argc, argv);
  if (!arguments) return 2;
  rbpa_bench::report(arguments->points, arguments->runs);
}
