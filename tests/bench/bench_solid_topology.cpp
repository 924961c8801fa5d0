// Measures the steps after solid(): boundary, measures, counts, components and voids, beside the time of solid()
// itself, in one thread.
//   bench_solid_topology [--points=N] [--runs=N]      1,000,000 points, the least of 3 runs
#include <cmath>
#include <cstdio>

#include "bench/options.h"
#include "bench/tables.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_components.h"
#include "rbpa/space/solid/solid_topology.h"
#include "rbpa/space/solid/voids.h"
#include "support/solid_sets.h"

namespace rbpa_bench {
namespace {

/// Measures the steps in turn; the first round makes what the later steps need.
void measure(const std::string& name, const rbpa_test::Points3& points, double alpha, int runs) {
  rbpa::Solid solid;
  rbpa::SolidBoundary boundary;
  rbpa::Voids voids;
  std::vector<Contestant> steps;
  const auto add = [&](auto step) {
    steps.push_back({"", [step] {
                       const Stopwatch watch;
                       step();
                       return watch.run(0);
                     }});
  };
  add([&] { solid = rbpa::solid(points, alpha, {.threads = 1}); });
  add([&] { boundary = rbpa::solid_boundary(solid); });
  add([&] { rbpa::measure(points, boundary.surface); });
  add([&] { rbpa::count(points, solid, boundary); });
  add([&] { rbpa::solid_components(points, solid, boundary); });
  add([&] { voids = rbpa::voids(points, solid, boundary); });
  const std::vector<Outcome> of = in_turn(steps, {.runs = runs, .by_processor = true});
  const auto n = static_cast<double>(points.size());
  const rbpa::SolidCounts& counts = voids.counts;
  std::vector<std::string> cells = {name,
                                    text("%zu", points.size()),
                                    text("%g", alpha),
                                    text("%.2f", static_cast<double>(counts.tetrahedra) / n),
                                    text("%.2f", static_cast<double>(counts.boundary_triangles) / n),
                                    text("%zu", counts.components),
                                    text("%zu", counts.tunnels),
                                    text("%zu", counts.voids)};
  for (const Outcome& step : of) cells.push_back(text("%.0f", 1e9 * step.seconds.least() / n) + step.failure);
  print_row(cells);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const auto [points, runs] = read_sizes(argc, argv, {.runs = 3});
  std::printf("%s; one thread, the least of %d runs of each in turn, nanoseconds of the processor a point.\n\n",
              machine().c_str(), runs);
  print_head({"points"},
             {"count", "alpha", "tetrahedra a point", "boundary triangles a point", "components", "tunnels", "voids",
              "solid()", "solid_boundary()", "measure()", "count()", "solid_components()", "voids()"});
  for (const double alpha : {0.5, 0.6, 0.7, 0.8, 1.0, double{INFINITY}})
    measure("uniform", rbpa_test::uniform_cube(points, 1), alpha, runs);
  measure("integer grid", rbpa_test::cubic_grid(points, 1, 3), 0.9, runs);
  measure("clusters", rbpa_test::clusters_in_cube(points, 5), 0.01, runs);
  measure("sphere, rounded", rbpa_test::on_unit_sphere(points, 6), INFINITY, runs);
}
