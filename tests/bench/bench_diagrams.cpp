// Measures constrained_delaunay() on coasts, and voronoi() on uniform points, and CGAL, in turn, one thread,
// with warm memory and in fresh processes.
//   bench_diagrams [--runs=N] [--points=N]      5 runs of each in turn, of about 1,000,000 points
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <vector>

#include "bench/options.h"
#include "bench/peers.h"
#include "bench/process.h"
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

/// Times of one contestant, of the processor: in a process that keeps its memory, and in fresh processes.
struct Times {
  Timings warm = {}, fresh = {};
  std::size_t count = 0;
};

/// Measures contestants in turn. Each run is in a child, as the pages and the heap of one contestant help or hinder the
/// next one: one run in a fresh child, or the fourth run in one that keeps its memory.
void print(const char* what, std::size_t points, const std::vector<std::function<Run()>>& contestants, int runs) {
  std::vector<Times> times(contestants.size());
  for (int round = 0; round < runs; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const auto& run = contestants[i];
      const auto fresh = in_child<Run>(run);
      const auto warm = in_child<Run>([&] {
        keep_memory();
        for (int before = 0; before < 3; ++before) run();
        return run();
      });
      if (!fresh || !warm || fresh->count != warm->count) throw std::runtime_error("a run has failed");
      times[i].fresh.of.push_back(fresh->processor_seconds);
      times[i].warm.of.push_back(warm->processor_seconds);
      times[i].count = warm->count;
    }
  const Times &ours = times[0], &cgal = times[1];
  if (ours.count != cgal.count) throw std::runtime_error("the results differ in size");
  print_row({what, text("%zu", points), text("%zu", ours.count), ours.warm.text(3), cgal.warm.text(3),
             text("%.2f", cgal.warm.median() / ours.warm.median()), ours.fresh.text(3), cgal.fresh.text(3),
             text("%.2f", cgal.fresh.median() / ours.fresh.median())});
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const auto [most, runs] = read_sizes(argc, argv);
  std::printf("%s; one thread, %d runs of each in turn, each in a process.\n\n", machine().c_str(), runs);
  std::printf("Seconds of processor time with warm memory and in fresh processes: median (min–max).\n\n");
  print_head({"what"}, {"points", "triangles or vertices", "rbpa, warm", "CGAL, warm", "CGAL / rbpa", "rbpa, fresh",
                        "CGAL, fresh", "CGAL / rbpa"});
  const Coasts coasts = coasts_of(most);
  print("constrained Delaunay triangulation of coasts", coasts.points.size(),
        {[&] {
           const Stopwatch watch;
           const auto made = rbpa::constrained_delaunay(coasts.points, coasts.segments, {.threads = 1});
           return watch.run(made.triangles.size());
         },
         [&] { return constrained_by_cgal(coasts.points, coasts.segments); }},
        runs);
  const std::vector<Point> points = uniform(most);
  print("Voronoi diagram of uniform points", points.size(),
        {[&] {
           const Stopwatch watch;
           const rbpa::Voronoi made = rbpa::voronoi(rbpa::Delaunay(points, {.threads = 1}));
           return watch.run(made.vertices.size());
         },
         [&] { return voronoi_by_cgal(points); }},
        runs);
}
