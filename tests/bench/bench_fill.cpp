// Measures fill() against CGAL's Delaunay refinement, and on inputs on which fronts get slow
// (docs/explanation/plane.md, section 28).
//   bench_fill [--runs=N] [--points=N]      3 runs of each in turn, of up to 1,000,000 triangles
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bench/options.h"
#include "bench/peers.h"
#include "bench/tables.h"
#include "rbpa/fill.h"

namespace rbpa_bench {
namespace {

using Ring = std::vector<rbpa::Point>;

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

/// Fills one ring by the library. At a size of infinity no point is added.
Run fill_by_rbpa(const Ring& ring, double size, bool graded = false) {
  std::vector<rbpa::Polygon> polygons(1);
  for (std::uint32_t i = 0; i < ring.size(); ++i) polygons[0].shell.points.push_back(i);
  rbpa::FillOptions options{.size = size};
  if (graded) options.grade = 0.05;
  const Stopwatch watch;
  const rbpa::Filling filling = rbpa::fill(ring, polygons, options);
  return watch.run(filling.triangles.size());
}

/// Measures ours, and a peer that may make another number of triangles.
void measure(const std::string& name, int runs, const std::function<Run()>& ours,
             const std::function<Run()>& peer = {}) {
  std::vector<Contestant> contestants = {{"fill", ours}};
  if (peer) contestants.push_back({"CGAL", peer, /*is_exact=*/false});
  std::vector<std::string> cells = {name};
  const std::vector<Outcome> of = in_turn(contestants, {.runs = runs, .by_processor = true});
  for (const Outcome& outcome : of) {
    cells.push_back(text("%zu", outcome.count));
    cells.push_back(outcome.seconds.text(2, 1e6 / static_cast<double>(outcome.count)) + outcome.failure);
  }
  cells.resize(5);
  print_row(cells);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const auto [most, runs] = read_sizes(argc, argv, {.runs = 3});
  std::printf("%s; one thread, %d runs of each in turn.\n\n", machine().c_str(), runs);
  std::printf("Microseconds of processor time a triangle: median (min–max).\n\n");
  print_head({"polygon"}, {"triangles", "fill", "CGAL's triangles", "CGAL"});
  // CGAL's criterion is the longest edge, ours is the target length: with a criterion 1.5 times as long, both make
  // about equally many triangles.
  const Ring plate = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t count = 10000; count <= most; count *= 10) {
    const double size = std::sqrt(4 / std::sqrt(3.0) / static_cast<double>(count));
    measure(
        text("unit square, size %.3g", size), runs, [&] { return fill_by_rbpa(plate, size); },
        [&] { return fill_by_cgal(plate, 1.5 * size); });
  }
  for (std::size_t count = 10000; count <= most / 10; count *= 10) {
    const Ring ring = star(count / 2, 0.5);
    measure(
        text("star of %zu vertices, size inf; CGAL: constrained Delaunay", ring.size()), runs,
        [&] { return fill_by_rbpa(ring, INFINITY); }, [&] { return triangulate_by_cgal(ring); });
  }
  const Ring teeth = comb(20), rays = star(1000, 1e-4);
  measure("comb, 20 teeth of 2⁻⁴⁹ × 5, grade 0.05", runs, [&] { return fill_by_rbpa(teeth, 1, true); });
  measure("star, 1,000 rays", runs, [&] { return fill_by_rbpa(rays, 0.01); });
  measure("star, 1,000 rays, no cuts", runs, [&] { return fill_by_rbpa(rays, 10); });
}
