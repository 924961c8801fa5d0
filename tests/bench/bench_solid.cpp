// Measures tetrahedra of points in space by solid() and by CGAL's Delaunay_triangulation_3, in turn in one process, one
// thread each.
//   bench_solid [--points=N] [--runs=N]      1,000,000 points, the least of 3 runs; up to 3,000 on the moment curve
//   bench_solid --peer HXT=./hxt_peer        and another program (process.h), of points as float64 x y z, which writes
//                                            tetrahedra as four uint32 indices
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "bench/options.h"
#include "bench/peers.h"
#include "bench/process.h"
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

void measure(const std::string& name, const Points3& points, const std::vector<double>& alphas, int runs,
             const std::vector<PeerProgram>& peers) {
  if (points.empty()) return;  // the scan is not there
  const auto ours = [&](double alpha) {
    const Stopwatch watch;
    const rbpa::Solid solid = rbpa::solid(points, alpha, {.threads = 1});
    return watch.run(solid.simplices.size());
  };
  for (const double alpha : alphas) {
    // CGAL's circumradii are rounded, so that with a radius the numbers may differ.
    std::vector<Contestant> all = {{"solid()", [&] { return ours(alpha); }},
                                   {"CGAL", [&] { return solid_by_cgal(points, alpha); }, std::isinf(alpha)}};
    for (const PeerProgram& peer : peers)
      if (std::isinf(alpha))
        all.push_back({peer.name(), [&] {
                         const auto [rows, seconds] = peer.run<std::array<std::uint32_t, 4>>(std::span(points));
                         return Run{seconds, seconds, rows.size()};
                       }});
    const auto of = in_turn(all, {.runs = runs, .by_processor = true});
    const auto n = static_cast<double>(points.size());
    std::vector<std::string> row = {name, text("%zu", points.size()), text("%g", alpha),
                                    text("%.2f", static_cast<double>(of[0].count) / n),
                                    text("%.0f", 1e9 * of[0].seconds.least() / n)};
    for (std::size_t i = 1; i < of.size(); ++i) {
      const std::string fault = of[i].wrong + of[i].failure;
      row.push_back(text("%.0f", 1e9 * of[i].seconds.least() / n));
      row.push_back(text("%.2f", of[i].seconds.least() / of[0].seconds.least()) + (fault.empty() ? "" : ", " + fault));
    }
    row.resize(7 + 2 * peers.size());
    print_row(row);
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  std::vector<std::string> commands;
  const auto sizes = read_sizes(argc, argv, {.runs = 3}, {{"--peer", &commands, "NAME=COMMAND: another program"}});
  const std::vector<PeerProgram> peers(commands.begin(), commands.end());
  std::printf("%s; one thread, the least of %d runs of each in turn, seconds of the processor.\n\n", machine().c_str(),
              sizes.runs);
  std::vector<std::string> head = {"count",           "alpha",         "tetrahedra a point", "solid() ns a point",
                                   "CGAL ns a point", "CGAL / solid()"};
  for (const PeerProgram& peer : peers) {
    head.push_back(peer.name() + " ns a point");
    head.push_back(peer.name() + " / solid()");
  }
  print_head({"points"}, head);
  const auto row = [&](const char* name, const Points3& points, const std::vector<double>& alphas = {INFINITY}) {
    measure(name, points, alphas, sizes.runs, peers);
  };
  row("uniform", rbpa_test::uniform_cube(sizes.points, 1), {INFINITY, 1.0, 0.7});
  row("jittered grid", rbpa_test::jittered_cubes(sizes.points, 2));
  row("integer grid", rbpa_test::cubic_grid(sizes.points, 1, 3));
  row("grid of tenths", rbpa_test::cubic_grid(sizes.points, 0.1, 4));
  row("clusters", rbpa_test::clusters_in_cube(sizes.points, 5));
  for (const char* name : {"c3_nefertiti.xyz", "c3_pcl_mug_stereo.xyz"}) row(name, read_scan(name));
  row("sphere, rounded", rbpa_test::on_unit_sphere(sizes.points, 6));
  row("moment curve", rbpa_test::moment_curve(std::min<std::size_t>(sizes.points, 3000)));
}
