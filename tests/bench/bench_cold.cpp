// Measures single runs in fresh processes, in any order: the cold tables of docs/reference/performance.md.
//   bench_cold [--runs=N] [--points=N]      15 runs of each, 1,000,000 points
#include <cstdio>
#include <numeric>

#include "bench/contest.h"
#include "bench/options.h"
#include "bench/process.h"
#include "bench/tables.h"
#include "bench/workload.h"
#include "support/random.h"

namespace rbpa_bench {
namespace {

/// Costs of one method, a point.
struct Cold {
  Timings nanoseconds = {}, bytes = {};
  std::size_t triangles = 0;
};

struct Row {
  std::string set;
  std::size_t points;
  std::vector<Cold> of;  // for each of cold_methods()
};

/// Indices into cold_methods().
enum { mesh = 0, cgal = 6 };

Row run_all(const Workload& workload, const Sizes& sizes) {
  const rbpa_test::Points points = workload.make(sizes.points);
  const Folder folder;
  write_values(folder / "points", points);
  Row row{workload.name, points.size(), std::vector<Cold>(cold_methods().size())};
  // The order differs in each round: a process affects the next one, and this must not always be the same pair.
  rbpa_test::Random random(1);
  std::vector<std::size_t> order(row.of.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int round = 0; round < sizes.runs; ++round) {
    random.shuffle(order);
    for (const std::size_t i : order) {
      const auto [run, bytes] = run_cold(i, folder / "points");
      const auto n = static_cast<double>(points.size());
      row.of[i].nanoseconds.of.push_back(1e9 * run.seconds / n);
      row.of[i].bytes.of.push_back(bytes / n);
      row.of[i].triangles = run.count;
    }
  }
  return row;
}

void print_times(const Row& row) {
  std::vector<std::string> cells = {row.set, text("%zu", row.points)};
  for (const Cold& cold : row.of) {
    const double quartile = cold.nanoseconds.lower_quartile();
    cells.push_back(text("%.0f (%.0f)", quartile, cold.nanoseconds.median()));
    if (cold.triangles != row.of[mesh].triangles) cells.back() += text(" **wrong**: %zu triangles", cold.triangles);
    if (&cold != &row.of[cgal]) cells.back() += text("; %.2f×", row.of[cgal].nanoseconds.lower_quartile() / quartile);
  }
  print_row(cells);
}

void report(const Sizes& sizes) {
  std::printf("%s; %d processes of each in turn, one run each.\n\n", machine().c_str(), sizes.runs);
  std::printf(
      "Nanoseconds a point: lower quartile (median); how many times as fast as CGAL points, by the quartiles.\n\n");
  const std::vector<std::string> names = columns({"number"}, cold_methods());
  print_head({"points"}, names);
  std::vector<Row> rows;
  for (const Workload& workload : {uniform, jittered, grid, lidar, clusters, kuzmin}) {
    rows.push_back(run_all(workload, sizes));
    print_times(rows.back());
  }
  std::printf("\nBytes a point: how far resident memory rises above what it was with the points in it; median.\n\n");
  print_head({"points"}, names);
  for (const Row& row : rows) {
    std::vector<std::string> cells = {row.set, text("%zu", row.points)};
    for (const Cold& cold : row.of) cells.push_back(text("%.0f", cold.bytes.median()));
    print_row(cells);
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  rbpa_bench::answer_cold_run(argc, argv);
  rbpa_bench::report(rbpa_bench::read_sizes(argc, argv, {.runs = 15}));
}
