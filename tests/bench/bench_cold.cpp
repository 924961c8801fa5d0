// Measures single runs in fresh processes, in any order: the cold tables of docs/reference/performance.md, and their
// targets.
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
  Timings nanoseconds = {}, processor = {}, bytes = {};
  std::size_t triangles = 0;
};

struct Row {
  std::string set;
  std::size_t points;
  std::vector<Cold> of;  // for each of cold_methods()
};

/// Indices into cold_methods().
enum { mesh, mesh_2, arrays, arrays_2, neighbors, neighbors_2, cgal };

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
      row.of[i].processor.of.push_back(1e9 * run.processor_seconds / n);
      row.of[i].bytes.of.push_back(bytes / n);
      row.of[i].triangles = run.count;
    }
  }
  return row;
}

void print_costs(const Row& row, Timings Cold::*times) {
  std::vector<std::string> cells = {row.set, text("%zu", row.points)};
  for (const Cold& cold : row.of) {
    const double quartile = (cold.*times).lower_quartile();
    cells.push_back(text("%.0f (%.0f)", quartile, (cold.*times).median()));
    if (cold.triangles != row.of[mesh].triangles) cells.back() += text(" **wrong**: %zu triangles", cold.triangles);
    if (&cold != &row.of[cgal]) cells.back() += text("; %.2f×", (row.of[cgal].*times).lower_quartile() / quartile);
  }
  print_row(cells);
}

/// Set of points, and the factors by which the mesh and arrays are to be faster than CGAL.
struct Wanted {
  const Workload& workload;
  double mesh, arrays;
};

void add_targets(const Wanted& wanted, const Row& row, std::vector<Target>& all) {
  const auto time = [&](std::size_t i) { return row.of[i].nanoseconds.lower_quartile(); };
  const auto bytes = [&](std::size_t i) { return row.of[i].bytes.median(); };
  const std::string set = row.set + ": ";
  all.push_back({set + "CGAL points / rbpa", "≥", wanted.mesh, time(cgal) / time(mesh)});
  all.push_back({set + "CGAL points / arrays", "≥", wanted.arrays, time(cgal) / time(arrays)});
  all.push_back({set + "rbpa, one thread / two", "≥", 1.6, time(mesh) / time(mesh_2)});
  all.push_back({set + "arrays, one thread / two", "≥", 1.6, time(arrays) / time(arrays_2)});
  all.push_back({set + "bytes a point, rbpa", "≤", 180, bytes(mesh)});
  all.push_back({set + "bytes a point, arrays", "≤", 90, bytes(arrays)});
  all.push_back({set + "bytes a point, arrays with neighbors", "≤", 115, bytes(neighbors)});
}

void report(const Sizes& sizes) {
  std::printf("%s; %d processes of each in turn, one run each.\n\n", machine().c_str(), sizes.runs);
  std::printf(
      "Nanoseconds a point: lower quartile (median); how many times as fast as CGAL points, by the quartiles.\n\n");
  const std::vector<std::string> names = columns({"number"}, cold_methods());
  print_head({"points"}, names);
  std::vector<Row> rows;
  std::vector<Target> targets;
  for (const Wanted& wanted : {Wanted{uniform, 2.6, 3}, Wanted{jittered, 2.6, 3}, Wanted{grid, 2.6, 3},
                               Wanted{lidar, 2.6, 3}, Wanted{clusters, 2, 2.4}, Wanted{kuzmin, 2, 2.4}}) {
    rows.push_back(run_all(wanted.workload, sizes));
    print_costs(rows.back(), &Cold::nanoseconds);
    add_targets(wanted, rows.back(), targets);
  }
  std::printf(
      "\nThe same by the processor's time, of all threads together: what is left when others on the machine are taken "
      "out.\n\n");
  print_head({"points"}, names);
  for (const Row& row : rows) print_costs(row, &Cold::processor);
  std::printf("\nBytes a point: how far resident memory rises above what it was with the points in it; median.\n\n");
  print_head({"points"}, names);
  for (const Row& row : rows) {
    std::vector<std::string> cells = {row.set, text("%zu", row.points)};
    for (const Cold& cold : row.of) cells.push_back(text("%.0f", cold.bytes.median()));
    print_row(cells);
  }
  print(targets);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  rbpa_bench::answer_cold_run(argc, argv);
  rbpa_bench::report(rbpa_bench::read_sizes(argc, argv, {.runs = 15}));
}
