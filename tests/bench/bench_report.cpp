// Compares rbpa() with CGAL and any other program, in turn on the same points, and prints the tables of
// docs/reference/performance.md: times and memory. Standard output is Markdown.
//   bench_report [--points=N] [--runs=N] [--threads=1,2] [--large] [--check] [--peer NAME=COMMAND]…
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "bench/contest.h"
#include "bench/options.h"
#include "bench/process.h"
#include "bench/tables.h"
#include "bench/workload.h"

namespace rbpa_bench {
namespace {

struct Task {
  Workload workload;
  std::size_t points;
  double alpha;
  std::string alpha_text;
};

/// Plan of a table of contests.
struct Plan {
  std::string heading;
  std::vector<Method> methods;
  std::vector<Task> tasks;
  std::vector<double> bytes = {};  ///< of each method of each task, where they are wanted
};

struct Arguments {
  std::vector<unsigned> threads = {1, 2};
  std::vector<std::string> peers = {};
  bool large = false, check = false;
};

class Report {
 public:
  Report(const Sizes& sizes, const Arguments& arguments) : sizes_(sizes), check_(arguments.check) {
    for (const unsigned threads : arguments.threads) ours_.push_back(rbpa_with(threads));
    for (const std::string& argument : arguments.peers) peers_.push_back(peer(argument));
    const std::size_t n = sizes.points;
    for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar})
      delaunay_.tasks.push_back({workload, n, INFINITY, "∞"});
    delaunay_.tasks.push_back({uniform, n / 10, INFINITY, "∞"});
    if (arguments.large) delaunay_.tasks.push_back({uniform, 16 * n, INFINITY, "∞"});
  }

  void run() {
    const std::size_t n = sizes_.points, few = n / 10;
    std::printf("%s; %d runs of each in turn after one that does not count; memory stays with the process.\n\n",
                machine().c_str(), sizes_.runs);
    std::printf(
        "Nanoseconds a point: median (least–most); how many times the median of %s. `in N`: N runs only, as they take "
        "long.\n",
        ours_[0].name.c_str());
    std::fflush(stdout);  // otherwise child processes would print it again
    // Peers find all Delaunay triangles, so that they compete with the others without a radius.
    delaunay_.methods = ours_and({cgal_points(), cgal_indices()});
    delaunay_.methods.insert(delaunay_.methods.end(), peers_.begin(), peers_.end());
    Plan of_few = {"With a radius, fewer points",
                   ours_and({cgal_points_filtered(), cgal_indices_filtered(), cgal_alpha_shape()}),
                   {{uniform, few, 3, "3"}}};
    for (Plan* plan : {&delaunay_, &of_few}) weigh(*plan);
    keep_memory();

    hold(delaunay_);
    hold({"With a radius; α in mean spacings",
          ours_and({cgal_points_filtered(), cgal_indices_filtered(), cgal_points(), cgal_indices()}),
          {{uniform, n, 3, "3"}, {jittered, n, 3, "3"}, {grid, n, 3, "3"}}});
    hold(of_few);
    const double spacing = spacing_along_curves(curves.make(few));
    hold({"Traps",
          ours_and({cgal_points_filtered()}),
          {{circle, few, 0.99, "0.99 radii"},
           {circle, few, 2, "2 radii"},
           {circle_line_cluster, few, 0.99, "0.99 radii"},
           {circle_line_cluster, few, 2, "2 radii"},
           {curves, few, 100 * spacing, "100 spacings"},
           {concentric, few, 0.07, "0.07 radii"},
           {concentric, few, 2, "2 radii"}}});
  }

 private:
  std::vector<Method> ours_and(std::vector<Method> others) const {
    others.insert(others.begin(), ours_.begin(), ours_.end());
    return others;
  }

  /// Measures the memory of each method but of other programs.
  void weigh(Plan& plan) const {
    for (const Task& task : plan.tasks)
      for (const Method& method : plan.methods) {
        const bool is_peer =
            std::any_of(peers_.begin(), peers_.end(), [&](const Method& p) { return p.name == method.name; });
        const auto work = [&]() -> double {
          const rbpa_test::Points points = task.workload.make(task.points);
          return rise_of_peak([&] { method.run(points, task.alpha, nullptr); });
        };
        plan.bytes.push_back(is_peer ? NAN : in_child<double>(work).value_or(NAN));
      }
  }

  void hold(const Plan& plan) const {
    std::printf("\n### %s\n\n", plan.heading.c_str());
    print_head({"points"}, columns({"number", "α", "triangles"}, plan.methods));
    std::vector<Contest> contests;
    std::size_t weighed = 0;
    for (const Task& task : plan.tasks) {
      const rbpa_test::Points points = task.workload.make(task.points);
      Contest contest{task.workload.name, task.alpha_text, points.size(),
                      in_turn(on(points, task.alpha, plan.methods), {.runs = sizes_.runs, .warm = true})};
      if (check_) compare_sets(points, task.alpha, plan.methods, contest);
      for (Outcome& outcome : contest.outcomes)
        if (!plan.bytes.empty()) outcome.bytes = plan.bytes[weighed++];
      print_times(contest);
      contests.push_back(std::move(contest));
    }
    if (!plan.bytes.empty()) print_bytes(contests);
  }

  Sizes sizes_;
  bool check_;
  std::vector<Method> ours_ = {}, peers_ = {};
  Plan delaunay_ = {"Without a radius", {}, {}};
};

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  Arguments arguments;
  const Sizes sizes =
      read_sizes(argc, argv, {},
                 {{"--threads", &arguments.threads, "of rbpa, 1,2; others are compared with the first"},
                  {"--large", &arguments.large, "also measure sixteen times the points"},
                  {"--check", &arguments.check, "compare sets of triangles, not only their numbers"},
                  {"--peer", &arguments.peers, "NAME=COMMAND: COMMAND IN OUT takes part (tests/bench/contest.h)"}});
  try {
    Report(sizes, arguments).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_report: %s\n", error.what());
    return 2;
  }
}
