// Measures fill() against CGAL's Delaunay refinement, and inputs on which fronts get slow (docs/explanation/plane.md,
// section 28).
//   bench_fill [--runs=N] [--points=N]      3 runs of each in turn, of up to 1,000,000 triangles
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/fill_contest.h"
#include "bench/machine.h"
#include "bench/stopwatch.h"
#include "bench/timings.h"
#include "rbpa/fill.h"

namespace rbpa_bench {
namespace {

using Ring = std::vector<rbpa::Point>;

const Ring plate = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Ring star(std::size_t rays, double inner) {
  Ring ring;
  for (std::size_t i = 0; i < 2 * rays; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(rays);
    const double radius = i % 2 == 1 ? 1 : inner;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

/// Returns teeth five units long, as narrow as the last places of their coordinates allow.
Ring comb(std::size_t teeth) {
  const double width = std::ldexp(1.0, -49);
  Ring ring = {{0, 0}};
  for (std::size_t i = 1; i <= teeth; ++i) {
    const double x = static_cast<double>(i) * width;
    ring.push_back({x, 0});
    ring.push_back({x + std::ldexp(1.0, -80), 5});
    ring.push_back({x + std::ldexp(1.0, -79), 0});
  }
  const double right = ring.back().x;
  ring.push_back({right, 6});
  ring.push_back({0, 6});
  return ring;
}

struct Times {
  Timings of = {};  ///< microseconds per triangle
  std::size_t triangles = 0;
  void add(const FillRun& run) {
    triangles = run.triangles;
    of.of.push_back(1e6 * run.seconds / static_cast<double>(run.triangles));
  }
};

/// CGAL's criterion is the longest edge, ours is the target length: with a criterion 1.5 times as long, both make about
/// equally many triangles.
void against_cgal(std::size_t most, int runs) {
  std::printf("Microseconds of processor time a triangle: median (min–max).\n\n");
  std::printf("| unit square | triangles | fill | CGAL's triangles | CGAL's Delaunay_mesher_2 | fill / CGAL |\n");
  std::printf("|---|--:|--:|--:|--:|--:|\n");
  for (std::size_t count = 10000; count <= most; count *= 10) {
    const double size = std::sqrt(4 / std::sqrt(3.0) / static_cast<double>(count));
    Times ours, peer;
    for (int run = 0; run < runs; ++run) {
      ours.add(fill_by_rbpa(plate, size, false));
      peer.add(fill_by_cgal(plate, 1.5 * size));
    }
    std::printf("| size %.3g | %zu | %s | %zu | %s | %.2f |\n", size, ours.triangles, ours.of.text(2).c_str(),
                peer.triangles, peer.of.text(2).c_str(), ours.of.median() / peer.of.median());
    std::fflush(stdout);
  }
}

void slow_inputs(int runs) {
  struct Row {
    std::string name;
    Ring ring;
    double size;
    bool graded;
  };
  std::printf("\n| input | triangles | fill, µs a triangle |\n|---|--:|--:|\n");
  for (const auto& [name, ring, size, graded] : {Row{"comb, 20 teeth of 2⁻⁴⁹ × 5, grade 0.05", comb(20), 1, true},
                                                 Row{"star, 1,000 rays", star(1000, 1e-4), 0.01, false},
                                                 Row{"star, 1,000 rays, no cuts", star(1000, 1e-4), 10, false}}) {
    Times ours;
    for (int run = 0; run < runs; ++run) ours.add(fill_by_rbpa(ring, size, graded));
    std::printf("| %s | %zu | %s |\n", name.c_str(), ours.triangles, ours.of.text(1).c_str());
    std::fflush(stdout);
  }
}

void without_a_size(std::size_t most, int runs) {
  std::printf(
      "\n| star, vertices | fill at infinity, µs a triangle | CGAL's constrained Delaunay, µs a triangle "
      "|\n|--:|--:|--:|\n");
  for (std::size_t count = 10000; count <= most; count *= 10) {
    const Ring ring = star(count / 2, 0.5);
    Times ours, peer;
    for (int run = 0; run < runs; ++run) {
      ours.add(fill_by_rbpa(ring, std::numeric_limits<double>::infinity(), false));
      peer.add(triangulate_by_cgal(ring));
    }
    std::printf("| %zu | %s | %s |\n", ring.size(), ours.of.text(2).c_str(), peer.of.text(2).c_str());
    std::fflush(stdout);
  }
}

}  // namespace

FillRun fill_by_rbpa(const Ring& ring, double size, bool graded) {
  std::vector<rbpa::Polygon> polygons(1);
  for (std::uint32_t i = 0; i < ring.size(); ++i) polygons[0].shell.points.push_back(i);
  rbpa::FillOptions options{.size = size};
  if (graded) options.grade = 0.05;
  const Stopwatch watch;
  const rbpa::Filling filling = rbpa::fill(ring, polygons, options);
  return {filling.triangles.size(), watch.processor_seconds()};
}

}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse(argc, argv, {}, {.runs = 3});
  if (!arguments) return 2;
  std::printf("%s; one thread, %d runs of each in turn.\n\n", rbpa_bench::machine_and_build().c_str(), arguments->runs);
  rbpa_bench::against_cgal(arguments->points, arguments->runs);
  rbpa_bench::slow_inputs(arguments->runs);
  rbpa_bench::without_a_size(arguments->points / 10, arguments->runs);
}
