// Measures single runs in fresh processes, in any order: the cold tables of docs/reference/performance.md, and their
// targets.
//   bench_cold [--runs=N] [--points=N]      15 runs of each, 1,000,000 points
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/cold.h"
#include "bench/machine.h"
#include "bench/tables.h"
#include "bench/timings.h"
#include "bench/workload.h"
#include "support/random.h"

namespace rbpa_bench {
namespace {

/// The costs of the runs of one contestant on one set.
struct Cold {
  Timings nanoseconds;  // per point
  Timings processor;    // nanoseconds of processor time per point
  Timings bytes;        // per point
  std::size_t triangles = 0;
};

struct Row {
  std::string set;
  std::size_t points;
  std::vector<Cold> of;  // for each contestant

  double time(std::size_t contestant) const { return of[contestant].nanoseconds.lower_quartile(); }
  double processor(std::size_t contestant) const { return of[contestant].processor.lower_quartile(); }
};

/// Indices into cold_contestants().
enum { mesh, mesh_2, arrays, arrays_2, neighbors, neighbors_2, cgal };

Row run_all(const std::string& program, const Workload& workload, std::size_t count, int runs) {
  const rbpa_test::Points points = workload.make(count);
  const PointsFile file(points);
  const std::size_t contestants = cold_contestants().size();
  Row row{workload.name, points.size(), std::vector<Cold>(contestants)};
  // The order differs in each round: a process affects the next one, and this must not always be the same pair.
  rbpa_test::Random random(1);
  std::vector<std::size_t> order(contestants);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int round = 0; round < runs; ++round) {
    random.shuffle(order);
    for (const std::size_t i : order) {
      const ColdRun run = run_cold(program, i, file.path());
      const auto n = static_cast<double>(points.size());
      row.of[i].nanoseconds.of.push_back(1e9 * run.seconds / n);
      row.of[i].processor.of.push_back(1e9 * run.processor_seconds / n);
      row.of[i].bytes.of.push_back(run.bytes / n);
      row.of[i].triangles = run.triangles;
    }
  }
  return row;
}

void print_heads() {
  std::printf("| points | number |");
  for (const Contestant& contestant : cold_contestants()) std::printf(" %s |", contestant.name.c_str());
  std::printf("\n|---|--:|");
  for (std::size_t i = 0; i < cold_contestants().size(); ++i) std::printf("--:|");
  std::printf("\n");
}

void print_times(const Row& row) {
  std::printf("| %s | %zu |", row.set.c_str(), row.points);
  for (std::size_t i = 0; i < row.of.size(); ++i) {
    std::printf(" %.0f (%.0f)", row.time(i), row.of[i].nanoseconds.median());
    if (row.of[i].triangles != row.of[mesh].triangles) std::printf(" **wrong**: %zu triangles", row.of[i].triangles);
    std::printf(i == cgal ? " |" : "; %.2f× |", row.time(cgal) / row.time(i));
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print_processor(const Row& row) {
  std::printf("| %s | %zu |", row.set.c_str(), row.points);
  for (std::size_t i = 0; i < row.of.size(); ++i) {
    std::printf(" %.0f (%.0f)", row.processor(i), row.of[i].processor.median());
    std::printf(i == cgal ? " |" : "; %.2f× |", row.processor(cgal) / row.processor(i));
  }
  std::printf("\n");
}

void print_bytes(const Row& row) {
  std::printf("| %s | %zu |", row.set.c_str(), row.points);
  for (const Cold& cold : row.of) std::printf(" %.0f |", cold.bytes.median());
  std::printf("\n");
}

/// The target of a set: the factor by which it must be faster than CGAL.
struct Wanted {
  const Workload& workload;
  double mesh, arrays;
};

void add_targets(const Wanted& wanted, const Row& row, std::vector<Target>& all) {
  const auto target = [&](const std::string& what, Sense sense, double bound, double measured) {
    all.push_back({row.set + ": " + what, sense, bound, measured});
  };
  target("CGAL points / rbpa", Sense::at_least, wanted.mesh, row.time(cgal) / row.time(mesh));
  target("CGAL points / arrays", Sense::at_least, wanted.arrays, row.time(cgal) / row.time(arrays));
  target("rbpa, one thread / two", Sense::at_least, 1.6, row.time(mesh) / row.time(mesh_2));
  target("arrays, one thread / two", Sense::at_least, 1.6, row.time(arrays) / row.time(arrays_2));
  target("bytes a point, rbpa", Sense::at_most, 180, row.of[mesh].bytes.median());
  target("bytes a point, arrays", Sense::at_most, 90, row.of[arrays].bytes.median());
  target("bytes a point, arrays with neighbors", Sense::at_most, 115, row.of[neighbors].bytes.median());
}

void report(const std::string& program, const Arguments& arguments) {
  std::printf("%s; %d processes of each in turn, one run each.\n\n", machine_and_build().c_str(), arguments.runs);
  std::printf(
      "Nanoseconds a point: lower quartile (median); how many times as fast as CGAL points, by the quartiles.\n\n");
  print_heads();
  std::vector<Row> rows;
  std::vector<Target> targets;
  for (const Wanted& wanted : {Wanted{uniform, 2.6, 3}, Wanted{jittered, 2.6, 3}, Wanted{grid, 2.6, 3},
                               Wanted{lidar, 2.6, 3}, Wanted{clusters, 2, 2.4}, Wanted{kuzmin, 2, 2.4}}) {
    rows.push_back(run_all(program, wanted.workload, arguments.points, arguments.runs));
    print_times(rows.back());
    add_targets(wanted, rows.back(), targets);
  }
  std::printf(
      "\nThe same by the processor's time, of all threads together: what is left when others on the machine are taken "
      "out.\n\n");
  print_heads();
  for (const Row& row : rows) print_processor(row);
  std::printf("\nBytes a point: how far resident memory rises above what it was with the points in it; median.\n\n");
  print_heads();
  for (const Row& row : rows) print_bytes(row);
  std::printf("\n");
  print(targets);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  std::size_t contestant = 0;
  if (argc == 3)
    if (const auto number = rbpa_bench::behind(argv[1], "--one=");
        number && rbpa_bench::read_number(*number, contestant))
      return rbpa_bench::one(contestant, argv[2]);
  const auto arguments = rbpa_bench::parse(argc, argv, {}, {.runs = 15});
  if (!arguments) return 2;
  rbpa_bench::report("/proc/self/exe", *arguments);
}
