// rbpa() against CGAL and any other program, in turn on the same points, as tables of docs/performance.md: times, memory,
// and the targets. Standard output is Markdown.
//   bench_report [--points=N] [--runs=N] [--threads=1,2] [--trap-points=N] [--large] [--check]
//                [--peer NAME=COMMAND]…
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/peer.h"
#include "bench/report_arguments.h"
#include "bench/tables.h"
#include "bench/targets.h"

namespace rbpa_bench {
namespace {

constexpr double infinity = INFINITY;

class Report {
 public:
  explicit Report(const ReportArguments& arguments) : arguments_(arguments) {
    for (const unsigned threads : arguments.threads) ours_.push_back(rbpa_with(threads));
    for (const auto& [name, command] : arguments.peers) peers_.push_back(peer(name, command));
  }

  void run() {
    print_machine(arguments_.runs);
    std::printf(
        "Nanoseconds a point: median (least–most); how many times the median of %s. `in N`: N runs only, as they take "
        "long.\n\n",
        ours_[0].name.c_str());
    const std::size_t points = arguments_.points;
    without_radius(points);
    with_radius(points);
    if (arguments_.trap_points > 0) traps(arguments_.trap_points);
    sweep(points);
    std::printf("### Targets\n\n");
    print(targets(measured_, points));
  }

 private:
  std::vector<Contestant> ours_and(std::vector<Contestant> others) const {
    others.insert(others.begin(), ours_.begin(), ours_.end());
    return others;
  }

  /// Peers find all Delaunay triangles, so that they meet the others where there is no radius.
  std::vector<Contestant> all_without_radius() const {
    std::vector<Contestant> all = ours_and({cgal_points, cgal_indices});
    all.insert(all.end(), peers_.begin(), peers_.end());
    return all;
  }

  std::vector<Contest> table(const std::string& heading, const std::vector<Task>& tasks,
                             const std::vector<Contestant>& contestants, bool memory) const {
    std::printf("### %s\n\n", heading.c_str());
    print_time_head(contestants);
    std::vector<Contest> contests;
    for (const Task& task : tasks) {
      contests.push_back(measure(task, contestants, {arguments_.runs, arguments_.check, memory}));
      print_time_row(contests.back());
    }
    std::printf("\n");
    print_clocks(contests);
    if (memory) {
      std::printf("Bytes a point: peak of resident memory beyond the input, in a process of its own.\n\n");
      print_memory(contests);
    }
    return contests;
  }

  void without_radius(std::size_t points) {
    std::vector<Task> tasks;
    for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar})
      tasks.push_back({workload, points, infinity, "∞"});
    tasks.push_back({uniform, points / 10, infinity, "∞"});
    if (arguments_.large) tasks.push_back({uniform, 16 * points, infinity, "∞"});
    measured_.delaunay = table("Without a radius", tasks, all_without_radius(), true);
  }

  void with_radius(std::size_t points) {
    std::vector<Contestant> all = ours_and({cgal_points_filtered, cgal_indices_filtered, cgal_points, cgal_indices});
    const std::vector<Task> tasks{{uniform, points, 3, "3"}, {jittered, points, 3, "3"}, {grid, points, 3, "3"}};
    measured_.alpha = table("With a radius; α in mean spacings", tasks, all, false);
    all.push_back(cgal_alpha_shape);
    table("With a radius, fewer points", {{uniform, points / 10, 3, "3"}}, all, true);
  }

  void traps(std::size_t points) {
    const double spacing = spacing_along_curves(curves.make(points));
    const std::vector<Task> tasks{{circle, points, 0.99, "0.99 radii"},
                                  {circle, points, 2, "2 radii"},
                                  {circle_line_cluster, points, 0.99, "0.99 radii"},
                                  {circle_line_cluster, points, 2, "2 radii"},
                                  {curves, points, 100 * spacing, "100 spacings"},
                                  {concentric, points, 0.07, "0.07 radii"},
                                  {concentric, points, 2, "2 radii"}};
    measured_.traps = table("Traps", tasks, ours_and({cgal_points_filtered}), false);
  }

  void sweep(std::size_t points) {
    std::vector<Task> tasks;
    for (const double alpha : {0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 30.0, 100.0, 300.0, 1000.0}) {
      char text[16];
      std::snprintf(text, sizeof text, "%g", alpha);
      tasks.push_back({uniform, points, alpha, text});
    }
    measured_.sweep =
        table("From one radius to the next; α in mean spacings", tasks, ours_and({cgal_points_filtered}), false);
  }

  const ReportArguments& arguments_;
  std::vector<Contestant> ours_, peers_;
  Measured measured_;
};

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse_report(argc, argv);
  if (!arguments) return 2;
  std::printf("`bench_report");
  for (int i = 1; i < argc; ++i) std::printf(" %s", argv[i]);
  std::printf("`\n\n");
  rbpa_bench::Report(*arguments).run();
}
