// Measures the steps after solid(): boundary, measures, counts, components and voids, beside the time of solid()
// itself, in one thread.
//   bench_solid_topology [--points=N] [--runs=N]      1,000,000 points, the least of 3 runs
#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/machine.h"
#include "bench/stopwatch.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_components.h"
#include "rbpa/space/solid/solid_topology.h"
#include "rbpa/space/solid/voids.h"
#include "support/solid_sets.h"

namespace rbpa_bench {
namespace {

using rbpa_test::Points3;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Workload {
  std::string name;
  Points3 points;
  std::vector<double> alphas;
};

void measure(const Workload& workload, double alpha, int runs) {
  const Points3& points = workload.points;
  rbpa::Solid solid;
  rbpa::SolidBoundary boundary;
  rbpa::Voids voids;
  const std::array<std::function<void()>, 6> calls = {[&] { solid = rbpa::solid(points, alpha, {.threads = 1}); },
                                                      [&] { boundary = rbpa::solid_boundary(solid); },
                                                      [&] { rbpa::measure(points, boundary.surface); },
                                                      [&] { rbpa::count(points, solid, boundary); },
                                                      [&] { rbpa::solid_components(points, solid, boundary); },
                                                      [&] { voids = rbpa::voids(points, solid, boundary); }};
  std::array<double, 6> least;
  least.fill(infinity);
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const Stopwatch watch;
      calls[i]();
      least[i] = std::min(least[i], watch.processor_seconds());
    }
  const auto n = static_cast<double>(points.size());
  const rbpa::SolidCounts& counts = voids.counts;
  std::printf("| %s | %g | %.2f | %.2f | %zu | %zu | %zu |", workload.name.c_str(), alpha,
              static_cast<double>(counts.tetrahedra) / n, static_cast<double>(counts.boundary_triangles) / n,
              counts.components, counts.tunnels, counts.voids);
  for (const double seconds : least) std::printf(" %.0f |", 1e9 * seconds / n);
  std::printf("\n");
  std::fflush(stdout);
}

void measure_all(std::size_t points, int runs) {
  std::vector<Workload> workloads;
  workloads.push_back({"uniform", rbpa_test::uniform_cube(points, 1), {0.5, 0.6, 0.7, 0.8, 1.0, infinity}});
  workloads.push_back({"integer grid", rbpa_test::cubic_grid(points, 1, 3), {0.9}});
  workloads.push_back({"clusters", rbpa_test::clusters_in_cube(points, 5), {0.01}});
  workloads.push_back({"sphere, rounded", rbpa_test::on_unit_sphere(points, 6), {infinity}});
  std::printf("%zu points.\n\n", points);
  std::printf(
      "| points | alpha | tetrahedra a point | boundary triangles a point | components | tunnels | voids | solid() ns "
      "a point | "
      "solid_boundary() | measure() | count() | solid_components() | voids() |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const Workload& workload : workloads)
    for (const double alpha : workload.alphas) measure(workload, alpha, runs);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse(argc, argv, {}, {.runs = 3});
  if (!arguments) return 2;
  std::printf("%s; one thread, the least of %d runs of each in turn, seconds of the processor.\n\n",
              rbpa_bench::machine_and_build().c_str(), arguments->runs);
  rbpa_bench::measure_all(arguments->points, arguments->runs);
}
