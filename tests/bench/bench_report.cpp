// Compares rbpa() with CGAL and any other program, in turn on the same points, and prints the tables of
// docs/reference/performance.md: times, memory, and the targets. Standard output is Markdown.
//   bench_report [--points=N] [--runs=N] [--threads=1,2] [--trap-points=N] [--large] [--check]
//                [--peer NAME=COMMAND]…
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "bench/memory.h"
#include "bench/peer.h"
#include "bench/report_arguments.h"
#include "bench/tables.h"
#include "bench/targets.h"

namespace rbpa_bench {
namespace {

constexpr double infinity = INFINITY;

/// Plan of a table of contests.
struct Plan {
  std::string heading;
  std::vector<Contestant> contestants;
  std::vector<Task> tasks;
  bool with_memory = false;
  std::vector<std::optional<double>> bytes = {};  ///< of each contestant of each task
};

class Report {
 public:
  explicit Report(const ReportArguments& arguments) : arguments_(arguments) {
    for (const unsigned threads : arguments.threads) ours_.push_back(rbpa_with(threads));
    for (const auto& [name, command] : arguments.peers) peers_.push_back(peer(name, command));
  }

  void run() const {
    print_machine(arguments_.runs);
    std::printf(
        "Nanoseconds a point: median (least–most); how many times the median of %s. `in N`: N runs only, as they take "
        "long.\n\n",
        ours_[0].name.c_str());
    std::fflush(stdout);  // otherwise child processes would print it again
    const std::size_t points = arguments_.points;
    Plan delaunay = without_radius(points), alpha = with_radius(points), few = with_radius_and_few(points / 10);
    for (Plan* plan : {&delaunay, &few}) weigh_all(*plan);
    keep_memory();

    Measured measured;
    measured.delaunay = hold(delaunay);
    measured.alpha = hold(alpha);
    hold(few);
    if (arguments_.trap_points > 0) measured.traps = hold(traps(arguments_.trap_points));
    measured.sweep = hold(sweep(points));
    std::printf("### Targets\n\n");
    print(targets(measured, points));
  }

 private:
  std::vector<Contestant> ours_and(std::vector<Contestant> others) const {
    others.insert(others.begin(), ours_.begin(), ours_.end());
    return others;
  }

  /// Peers find all Delaunay triangles, so that they compete with the others without a radius.
  Plan without_radius(std::size_t points) const {
    Plan plan{"Without a radius", ours_and({cgal_points, cgal_indices}), {}, true};
    plan.contestants.insert(plan.contestants.end(), peers_.begin(), peers_.end());
    for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar})
      plan.tasks.push_back({workload, points, infinity, "∞"});
    plan.tasks.push_back({uniform, points / 10, infinity, "∞"});
    if (arguments_.large) plan.tasks.push_back({uniform, 16 * points, infinity, "∞"});
    return plan;
  }

  Plan with_radius(std::size_t points) const {
    return {"With a radius; α in mean spacings",
            ours_and({cgal_points_filtered, cgal_indices_filtered, cgal_points, cgal_indices}),
            {{uniform, points, 3, "3"}, {jittered, points, 3, "3"}, {grid, points, 3, "3"}}};
  }

  Plan with_radius_and_few(std::size_t points) const {
    return {"With a radius, fewer points",
            ours_and({cgal_points_filtered, cgal_indices_filtered, cgal_alpha_shape}),
            {{uniform, points, 3, "3"}},
            true};
  }

  Plan traps(std::size_t points) const {
    const double spacing = spacing_along_curves(curves.make(points));
    return {"Traps",
            ours_and({cgal_points_filtered}),
            {{circle, points, 0.99, "0.99 radii"},
             {circle, points, 2, "2 radii"},
             {circle_line_cluster, points, 0.99, "0.99 radii"},
             {circle_line_cluster, points, 2, "2 radii"},
             {curves, points, 100 * spacing, "100 spacings"},
             {concentric, points, 0.07, "0.07 radii"},
             {concentric, points, 2, "2 radii"}}};
  }

  Plan sweep(std::size_t points) const {
    Plan plan{"From one radius to the next; α in mean spacings", ours_and({cgal_points_filtered}), {}};
    for (const double alpha : {0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 30.0, 100.0, 300.0, 1000.0}) {
      char text[16];
      std::snprintf(text, sizeof text, "%g", alpha);
      plan.tasks.push_back({uniform, points, alpha, text});
    }
    return plan;
  }

  static void weigh_all(Plan& plan) {
    for (const Task& task : plan.tasks)
      for (const Contestant& contestant : plan.contestants) plan.bytes.push_back(weigh(task, contestant));
  }

  std::vector<Contest> hold(const Plan& plan) const {
    std::printf("### %s\n\n", plan.heading.c_str());
    print_time_head(plan.contestants);
    std::vector<Contest> contests;
    std::size_t weighed = 0;
    for (const Task& task : plan.tasks) {
      Contest contest =
          measure(task, plan.contestants, {.runs = arguments_.runs, .warm = true, .check = arguments_.check});
      for (Outcome& outcome : contest.outcomes)
        if (plan.with_memory)
          if (const std::optional<double> bytes = plan.bytes[weighed++]) outcome.bytes = bytes;
      print_time_row(contest);
      contests.push_back(std::move(contest));
    }
    std::printf("\n");
    print_clocks(contests);
    if (plan.with_memory) {
      std::printf("Bytes a point: peak of resident memory beyond the input, in a process of its own.\n\n");
      print_memory(contests);
    }
    return contests;
  }

  const ReportArguments& arguments_;
  std::vector<Contestant> ours_, peers_;
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
