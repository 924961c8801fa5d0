// Measures constrained_delaunay() on coasts, and voronoi() on uniform points, and CGAL, in turn, one thread.
//   bench_diagrams [--runs=N] [--points=N]      5 runs of each in turn, of about 1,000,000 points
#include <cmath>
#include <cstdio>
#include <vector>

#include "bench/options.h"
#include "bench/peers.h"
#include "bench/tables.h"
#include "rbpa/plane/constrained_delaunay.h"
#include "rbpa/plane/voronoi.h"
#include "support/random.h"

namespace rbpa_bench {
namespace {

using rbpa::Point;

struct Coasts {
  std::vector<Point> points = {};
  std::vector<rbpa::Segment> segments = {};
};

/// Appends a coast from a to b, b excluded, of 2^depth segments: the middle of each is moved to one side.
void append_coast(const Point& a, const Point& b, int depth, rbpa_test::Random& random, std::vector<Point>& points) {
  if (depth == 0) return points.push_back(a);
  const double x = b.x - a.x, y = b.y - a.y, along = random.between(0.4, 0.6), aside = random.between(-0.035, 0.035);
  const Point middle{a.x + along * x - aside * y, a.y + along * y + aside * x};
  append_coast(a, middle, depth - 1, random, points);
  append_coast(middle, b, depth - 1, random, points);
}

/// Returns islands of 3 · 2^10 points each.
Coasts coasts_of(std::size_t points) {
  constexpr int depth = 10, in_row = 32;
  rbpa_test::Random random(1);
  Coasts coasts;
  for (int i = 0; coasts.points.size() < points; ++i) {
    const double x = 4 * (i % in_row), y = 4 * std::floor(i / in_row);
    const Point corner[] = {{x, y}, {x + 2, y}, {x + 1, y + 1.7}};
    const auto first = static_cast<std::uint32_t>(coasts.points.size());
    for (int k = 0; k < 3; ++k) append_coast(corner[k], corner[(k + 1) % 3], depth, random, coasts.points);
    const auto end = static_cast<std::uint32_t>(coasts.points.size());
    for (std::uint32_t k = first; k < end; ++k) coasts.segments.push_back({k, k + 1 == end ? first : k + 1});
  }
  return coasts;
}

std::vector<Point> uniform(std::size_t count) {
  rbpa_test::Random random(2);
  std::vector<Point> points(count);
  for (Point& p : points) p = {random.unit(), random.unit()};
  return points;
}

void print(const char* what, std::size_t points, const std::vector<Contestant>& contestants, int runs) {
  const auto of = in_turn(contestants, {.runs = runs, .by_processor = true});
  print_row({what, text("%zu", points), text("%zu", of[0].count), of[0].seconds.text(3, 1), of[1].seconds.text(3, 1),
             text("%.2f", of[1].seconds.median() / of[0].seconds.median())});
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const auto [most, runs] = read_sizes(argc, argv);
  std::printf("%s; one thread, %d runs of each in turn.\n\n", machine().c_str(), runs);
  std::printf("Seconds of processor time: median (min–max).\n\n");
  print_head({"what"}, {"points", "triangles or vertices", "rbpa", "CGAL", "CGAL / rbpa"});
  const Coasts coasts = coasts_of(most);
  print("constrained Delaunay triangulation of coasts", coasts.points.size(),
        {{"rbpa",
          [&] {
            const Stopwatch watch;
            const auto made = rbpa::constrained_delaunay(coasts.points, coasts.segments, {.threads = 1});
            return watch.run(made.triangles.size());
          }},
         {"CGAL", [&] { return constrained_by_cgal(coasts.points, coasts.segments); }}},
        runs);
  const std::vector<Point> points = uniform(most);
  print("Voronoi diagram of uniform points", points.size(),
        {{"rbpa",
          [&] {
            const Stopwatch watch;
            const rbpa::Voronoi made = rbpa::voronoi(rbpa::Delaunay(points, {.threads = 1}));
            return watch.run(made.vertices.size());
          }},
         {"CGAL", [&] { return voronoi_by_cgal(points); }}},
        runs);
}
