// Compares rbpa() and hrbpa() with CGAL's Delaunay triangulation of the points, in one process and one thread, by
// processor time, on a hundred sets made to find slow paths. Prints the table of docs/reference/performance.md, worst
// first.
//   bench_slow_paths [--runs=N] [--points=N]      5 runs of each; 100,000 points, and a twelfth of them
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/contest.h"
#include "bench/options.h"
#include "bench/process.h"
#include "bench/slow_paths.h"
#include "bench/tables.h"

namespace rbpa_bench {
namespace {

struct Row {
  SlowPath path;
  Contest contest;

  /// Returns the time as a multiple of CGAL's; infinite if one of them failed.
  double times_cgal(const std::string& ours) const {
    const double ratio = contest.ratio(ours, cgal_points().name);
    return std::isnan(ratio) ? INFINITY : ratio;
  }
  double rbpa() const { return times_cgal("rbpa"); }
  double levels() const { return times_cgal("hrbpa"); }
  /// Returns the ratio to the target: above 1 it is missed.
  double badness() const { return std::max(rbpa() / path.max_rbpa, levels() / path.max_hrbpa); }
};

Row run(const SlowPath& path, const Sizes& sizes) {
  const rbpa_test::Points points = path.workload.make(sizes.points);
  const double alpha = path.alpha ? path.alpha(points) : INFINITY;
  const std::vector<Method> methods = {rbpa_with(1), hrbpa(), cgal_points()};
  return {path,
          {path.workload.name, path.alpha_text, points.size(),
           in_turn(on(points, alpha, methods), {.runs = sizes.runs, .warm = true, .by_processor = true})}};
}

std::string marked(double ratio, double bound) { return text(ratio > bound ? "**%.2f**" : "%.2f", ratio); }

void print(std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.badness() > b.badness(); });
  const auto missed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.badness() > 1; });
  std::printf("%zu sets, %td missed.\n\n", rows.size(), missed);
  print_head({"points", "kind"},
             {"number", "α", "triangles", "rbpa", "hrbpa", "CGAL points", "rbpa / CGAL", "hrbpa / CGAL"});
  for (const Row& row : rows) {
    std::vector<std::string> cells = {row.contest.set, row.path.kind, text("%zu", row.contest.points),
                                      row.contest.alpha, text("%zu", row.contest.outcomes[0].count)};
    for (const Outcome& outcome : row.contest.outcomes)
      cells.push_back(!outcome.failure.empty() ? "**failed**: " + outcome.failure
                      : !outcome.wrong.empty() ? "**wrong**: " + outcome.wrong
                                               : text("%.0f", row.contest.nanoseconds(outcome.name)));
    cells.push_back(marked(row.rbpa(), row.path.max_rbpa));
    cells.push_back(marked(row.levels(), row.path.max_hrbpa));
    print_row(cells);
  }
  std::printf("\n");
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const Sizes sizes = read_sizes(argc, argv, {.points = 100000});
  keep_memory();
  std::printf("%s; %d runs of each in turn after one that does not count; memory stays with the process.\n\n",
              machine().c_str(), sizes.runs);
  std::printf(
      "Nanoseconds a point of the processor's time, medians; how many times CGAL's. Wanted: `rbpa` at most 1.2 and "
      "`hrbpa` at most 1.4 times CGAL's, both at most 2 times for exponents; **what is not met**.\n\n");
  for (const std::size_t points : {sizes.points, sizes.points * 2 / 25}) {
    std::vector<Row> rows;
    for (const SlowPath& path : slow_paths()) rows.push_back(run(path, {points, sizes.runs}));
    std::printf("### %zu points\n\n", points);
    print(rows);
  }
}
