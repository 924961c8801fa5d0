// Compares rbpa() and hrbpa() with CGAL's Delaunay triangulation of the points, in one process and one thread, by
// processor time, on a hundred sets made to find slow paths. Prints the table of docs/reference/performance.md, worst
// first.
//   bench_slow_paths [--runs=N] [--points=N]      5 runs of each; 100,000 points, and a twelfth of them
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/measure.h"
#include "bench/memory.h"
#include "bench/slow_paths.h"
#include "bench/tables.h"

namespace rbpa_bench {
namespace {

struct Row {
  SlowPath path;
  Contest contest;

  /// Returns the time as a multiple of CGAL's; infinite if one of them failed.
  double times_cgal(const Contestant& ours) const {
    const auto ratio = speedup(contest, cgal_points.name, ours.name);
    return ratio.value_or(INFINITY);
  }
  bool is_met() const { return rbpa() <= path.max_rbpa && levels() <= path.max_hrbpa; }
  double rbpa() const { return times_cgal(rbpa_with(1)); }
  double levels() const { return times_cgal(hrbpa); }
  /// Returns the ratio to the target: above 1 it is missed.
  double badness() const { return std::max(rbpa() / path.max_rbpa, levels() / path.max_hrbpa); }
};

Row run(const SlowPath& path, std::size_t points, int runs) {
  const double alpha = path.alpha ? path.alpha(path.workload.make(points)) : INFINITY;
  return {path, measure({path.workload, points, alpha, path.alpha_text}, {rbpa_with(1), hrbpa, cgal_points},
                        {.runs = runs, .warm = true, .by_processor = true})};
}

std::string nanoseconds(const Contest& contest, const Outcome& outcome) {
  if (!outcome.failure.empty()) return "**failed**: " + outcome.failure;
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", contest.nanoseconds_a_point(outcome));
  return outcome.wrong.empty() ? text : "**wrong**: " + outcome.wrong + "; " + text;
}

std::string marked(double ratio, double bound) {
  char text[32];
  std::snprintf(text, sizeof text, ratio > bound ? "**%.2f**" : "%.2f", ratio);
  return text;
}

void print(std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.badness() > b.badness(); });
  const auto missed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.is_met(); });
  std::printf("%zu sets, %td missed.\n\n", rows.size(), missed);
  std::printf("| points | kind | number | α | triangles | rbpa | hrbpa | CGAL points | rbpa / CGAL | hrbpa / CGAL |\n");
  std::printf("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const Row& row : rows) {
    std::printf("| %s | %s | %zu | %s | %zu |", row.path.workload.name.c_str(), row.path.kind.c_str(),
                row.contest.points, row.path.alpha_text.c_str(), row.contest.outcomes[0].triangles);
    for (const Outcome& outcome : row.contest.outcomes) std::printf(" %s |", nanoseconds(row.contest, outcome).c_str());
    std::printf(" %s | %s |\n", marked(row.rbpa(), row.path.max_rbpa).c_str(),
                marked(row.levels(), row.path.max_hrbpa).c_str());
  }
  std::printf("\n");
}

/// Prints the cost of scaling by a power of two.
void print_scaling(const std::vector<Row>& rows) {
  const auto time = [&](const std::string& name) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.path.workload.name == name; });
    return row->contest.nanoseconds_a_point(row->contest.outcomes[0]);
  };
  for (const char* scaled : {"uniform · 2²⁰⁰", "uniform · 2⁻²⁰⁰"})
    std::printf("%s: %s times as long as uniform; at most 1.1 is wanted.\n\n", scaled,
                marked(time(scaled) / time("uniform"), 1.1).c_str());
}

void report(const Arguments& arguments) {
  print_machine(arguments.runs);
  std::printf(
      "Nanoseconds a point of the processor's time, medians; how many times CGAL's. Wanted: `rbpa` at most 1.2 and "
      "`hrbpa` at most 1.4 times "
      "CGAL's, both at most 2 times for exponents; **what is not met**.\n\n");
  for (const std::size_t points : {arguments.points, arguments.points * 2 / 25}) {
    std::vector<Row> rows;
    for (const SlowPath& path : slow_paths()) rows.push_back(run(path, points, arguments.runs));
    std::printf("### %zu points\n\n", points);
    print(rows);
    print_scaling(rows);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse(argc, argv, {}, {.points = 100000});
  if (!arguments) return 2;
  rbpa_bench::keep_memory();
  rbpa_bench::report(*arguments);
}
