// Measures tetrahedra of points in space by solid() and by CGAL's Delaunay_triangulation_3, in turn in one process, one
// thread each.
//   bench_solid [--points=N] [--runs=N]      1,000,000 points, the least of 3 runs; up to 3,000 on the moment curve
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bench/arguments.h"
#include "bench/machine.h"
#include "bench/solid_cgal.h"
#include "bench/stopwatch.h"
#include "rbpa/space/solid/solid.h"
#include "support/data_folder.h"
#include "support/solid_sets.h"

namespace rbpa_bench {
namespace {

using rbpa_test::Points3;

struct Workload {
  std::string name;
  Points3 points;
  std::vector<double> alphas;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

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

SolidRun solid_by_rbpa(const Points3& points, double alpha) {
  const Stopwatch watch;
  const rbpa::Solid solid = rbpa::solid(points, alpha, {.threads = 1});
  return {solid.simplices.size(), watch.processor_seconds()};
}

void measure(const Workload& workload, int runs) {
  for (const double alpha : workload.alphas) {
    SolidRun ours{0, infinity}, cgal{0, infinity};
    for (int run = 0; run < runs; ++run) {
      const SolidRun mine = solid_by_rbpa(workload.points, alpha), its = solid_by_cgal(workload.points, alpha);
      ours = {mine.tetrahedra, std::min(ours.seconds, mine.seconds)};
      cgal = {its.tetrahedra, std::min(cgal.seconds, its.seconds)};
    }
    const auto n = static_cast<double>(workload.points.size());
    std::printf("| %s | %zu | %g | %.2f | %.0f | %.0f | %.2f |%s\n", workload.name.c_str(), workload.points.size(),
                alpha, static_cast<double>(ours.tetrahedra) / n, 1e9 * ours.seconds / n, 1e9 * cgal.seconds / n,
                cgal.seconds / ours.seconds,
                std::isinf(alpha) && ours.tetrahedra != cgal.tetrahedra ? " not equal" : "");
    std::fflush(stdout);
  }
}

void measure_all(std::size_t points, int runs) {
  std::vector<Workload> workloads;
  workloads.push_back({"uniform", rbpa_test::uniform_cube(points, 1), {infinity, 1.0, 0.7}});
  workloads.push_back({"jittered grid", rbpa_test::jittered_cubes(points, 2), {infinity}});
  workloads.push_back({"integer grid", rbpa_test::cubic_grid(points, 1, 3), {infinity}});
  workloads.push_back({"grid of tenths", rbpa_test::cubic_grid(points, 0.1, 4), {infinity}});
  workloads.push_back({"clusters", rbpa_test::clusters_in_cube(points, 5), {infinity}});
  for (const char* name : {"c3_nefertiti.xyz", "c3_pcl_mug_stereo.xyz"})
    if (std::filesystem::exists(rbpa_test::further_data() / name))
      workloads.push_back({name, read_scan(name), {infinity}});
  workloads.push_back({"sphere, rounded", rbpa_test::on_unit_sphere(points, 6), {infinity}});
  workloads.push_back({"moment curve", rbpa_test::moment_curve(std::min<std::size_t>(points, 3000)), {infinity}});
  std::printf(
      "| points | count | alpha | tetrahedra a point | solid() ns a point | CGAL ns a point | CGAL / solid() |\n"
      "|---|--:|--:|--:|--:|--:|--:|\n");
  for (const Workload& workload : workloads) measure(workload, runs);
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
