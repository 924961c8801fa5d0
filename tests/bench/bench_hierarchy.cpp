// Measures hrbpa(), rbpa() and CGAL, in turn on the same points, one thread (docs/explanation/plane.md,
// section 17).
//   bench_hierarchy [--runs=N] [--points=N]      5 runs of each in turn, on 1,000,000 points
#include <cmath>
#include <cstdio>

#include "bench/contest.h"
#include "bench/options.h"
#include "bench/tables.h"
#include "bench/workload.h"

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const Sizes sizes = read_sizes(argc, argv);
  std::printf("%s; one thread, %d runs of each in turn.\n\n", machine().c_str(), sizes.runs);
  std::printf("Nanoseconds a point: median (least–most); how many times as long as CGAL.\n\n");
  const std::vector<Method> methods = {cgal_indices(), rbpa_with(1), hrbpa()};
  print_head({"points"}, columns({"number", "α", "triangles"}, methods));
  for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar}) {
    const rbpa_test::Points points = workload.make(sizes.points);
    print_times({workload.name, "∞", points.size(), in_turn(on(points, INFINITY, methods), {.runs = sizes.runs})});
  }
}
