// Measures fill() and CGAL's Delaunay refinement on a unit square, in turn, one thread (docs/explanation/plane.md,
// section 28).
//   bench_fill [--runs=N] [--points=N]      3 runs of each in turn, of up to 1,000,000 triangles
#include <cmath>
#include <cstdio>

#include "bench/options.h"
#include "bench/peers.h"
#include "bench/tables.h"
#include "rbpa/fill.h"

namespace rbpa_bench {
namespace {

const std::vector<rbpa::Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Run fill_by_rbpa(double size) {
  std::vector<rbpa::Polygon> polygons(1);
  polygons[0].shell.points = {0, 1, 2, 3};
  const Stopwatch watch;
  const rbpa::Filling filling = rbpa::fill(square, polygons, {.size = size});
  return watch.run(filling.triangles.size());
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const auto [most, runs] = read_sizes(argc, argv, {.runs = 3});
  std::printf("%s; one thread, %d runs of each in turn.\n\n", machine().c_str(), runs);
  std::printf("Microseconds of processor time a triangle: median (min–max).\n\n");
  print_head({}, {"size", "triangles", "fill", "CGAL's triangles", "CGAL's Delaunay_mesher_2", "fill / CGAL"});
  // CGAL's criterion is the longest edge, ours is the target length: with a criterion 1.5 times as long, both make
  // about equally many triangles.
  for (std::size_t count = 10000; count <= most; count *= 10) {
    const double size = std::sqrt(4 / std::sqrt(3.0) / static_cast<double>(count));
    const auto of = in_turn({{"fill", [&] { return fill_by_rbpa(size); }},
                             {"CGAL", [&] { return fill_by_cgal(square, 1.5 * size); }, /*is_exact=*/false}},
                            {.runs = runs, .by_processor = true});
    const auto unit = [&](std::size_t i) { return 1e6 / static_cast<double>(of[i].count); };
    print_row({text("%.3g", size), text("%zu", of[0].count), of[0].seconds.text(2, unit(0)), text("%zu", of[1].count),
               of[1].seconds.text(2, unit(1)),
               text("%.2f", of[0].seconds.median() * unit(0) / (of[1].seconds.median() * unit(1)))});
  }
}
