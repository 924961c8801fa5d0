// Measures tetrahedra of points in space by solid() and by CGAL's Delaunay_triangulation_3, in turn in one process, one
// thread each.
//   bench_solid [--points=N] [--runs=N]      1,000,000 points, the least of 3 runs; up to 3,000 on the moment curve
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "bench/options.h"
#include "bench/peers.h"
#include "bench/tables.h"
#include "rbpa/space/solid/solid.h"
#include "support/data_folder.h"
#include "support/solid_sets.h"

namespace rbpa_bench {
namespace {

using rbpa_test::Points3;

Points3 read_scan(const std::string& name) {
  std::ifstream file(rbpa_test::further_data() / name);
  Points3 points;
  for (std::string line; std::getline(file, line);) {
    std::istringstream numbers(line);
    rbpa::Point3 p;
    if (numbers >> p.x >> p.y >> p.z) points.push_back(p);
  }
  return points;
}

void measure(const std::string& name, const Points3& points, const std::vector<double>& alphas, int runs) {
  if (points.empty()) return;  // the scan is not there
  const auto ours = [&](double alpha) {
    const Stopwatch watch;
    const rbpa::Solid solid = rbpa::solid(points, alpha, {.threads = 1});
    return watch.run(solid.simplices.size());
  };
  for (const double alpha : alphas) {
    // CGAL's circumradii are rounded, so that with a radius the numbers may differ.
    const auto of = in_turn({{"solid()", [&] { return ours(alpha); }},
                             {"CGAL", [&] { return solid_by_cgal(points, alpha); }, std::isinf(alpha)}},
                            {.runs = runs, .by_processor = true});
    const auto n = static_cast<double>(points.size());
    print_row({name, text("%zu", points.size()), text("%g", alpha), text("%.2f", static_cast<double>(of[0].count) / n),
               text("%.0f", 1e9 * of[0].seconds.least() / n), text("%.0f", 1e9 * of[1].seconds.least() / n),
               text("%.2f", of[1].seconds.least() / of[0].seconds.least()) + of[1].wrong});
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const auto [points, runs] = read_sizes(argc, argv, {.runs = 3});
  std::printf("%s; one thread, the least of %d runs of each in turn, seconds of the processor.\n\n", machine().c_str(),
              runs);
  print_head({"points"},
             {"count", "alpha", "tetrahedra a point", "solid() ns a point", "CGAL ns a point", "CGAL / solid()"});
  measure("uniform", rbpa_test::uniform_cube(points, 1), {INFINITY, 1.0, 0.7}, runs);
  measure("jittered grid", rbpa_test::jittered_cubes(points, 2), {INFINITY}, runs);
  measure("integer grid", rbpa_test::cubic_grid(points, 1, 3), {INFINITY}, runs);
  measure("grid of tenths", rbpa_test::cubic_grid(points, 0.1, 4), {INFINITY}, runs);
  measure("clusters", rbpa_test::clusters_in_cube(points, 5), {INFINITY}, runs);
  for (const char* name : {"c3_nefertiti.xyz", "c3_pcl_mug_stereo.xyz"})
    measure(name, read_scan(name), {INFINITY}, runs);
  measure("sphere, rounded", rbpa_test::on_unit_sphere(points, 6), {INFINITY}, runs);
  measure("moment curve", rbpa_test::moment_curve(std::min<std::size_t>(points, 3000)), {INFINITY}, runs);
}
