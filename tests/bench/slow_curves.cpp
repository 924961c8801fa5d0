#include "bench/slow_paths.h"

namespace rbpa_bench {
namespace {

using rbpa::Point;

/// Returns points of `number` circles around one center.
Points circles(std::size_t count, int number, std::uint64_t seed) {
  return scattered(count, seed, [=](Random& random) {
    const double radius = random.integer(1, number) / static_cast<double>(number);
    return polar(radius, random.unit());
  });
}

/// Returns a share of the points on a circle, and the others anywhere in it.
Points circle_and_inside(std::size_t count, double share, std::uint64_t seed) {
  return scattered(count, seed, [=](Random& random) {
    const double radius = random.chance(share) ? 1 : std::sqrt(random.unit());
    return polar(radius, random.unit());
  });
}

Points random_walk(std::size_t count, double persistence, std::uint64_t seed) {
  Point at{0, 0}, step{0, 0};
  return scattered(count, seed, [&](Random& random) {
    step = {persistence * step.x + normal(random), persistence * step.y + normal(random)};
    at = {at.x + step.x, at.y + step.y};
    return at;
  });
}

}  // namespace

void add_slow_curves(SlowPaths& all) {
  all.kind = "curve";
  all.curve("parabola", 1, [](double t) { return Point{2 * t - 1, (2 * t - 1) * (2 * t - 1)}; });
  all.curve("parabola, long", 2, [](double t) { return Point{1000 * t, 1e6 * t * t}; });
  all.each("parabola, both branches", 3, [](Random& random) {
    const double x = random.between(-1, 1);
    return Point{x, random.chance(0.5) ? x * x : -x * x};
  });
  all.curve("cubic", 4, [](double t) { return Point{2 * t - 1, std::pow(2 * t - 1, 3)}; });
  all.curve("sine, 10 periods", 5, [](double t) { return Point{t, std::sin(20 * std::numbers::pi * t)}; });
  all.curve("sine, 1000 periods", 6, [](double t) { return Point{t, std::sin(2000 * std::numbers::pi * t)}; });
  all.curve("exponential", 7, [](double t) { return Point{t, std::exp(10 * t)}; });
  all.curve("bell", 8, [](double t) { return Point{6 * t - 3, std::exp(-(6 * t - 3) * (6 * t - 3))}; });
  all.curve("hyperbola", 9, [](double t) { return Point{0.01 + t, 1 / (0.01 + t)}; });
  all.add("circle", [](std::size_t n) { return circles(n, 1, 10); });
  all.curve("half a circle", 11, [](double t) { return polar(1, t / 2); });
  all.add("circle and center", [](std::size_t n) {
    Points points = circles(n - 1, 1, 13);
    points.push_back({0, 0});
    return points;
  });
  all.add("circle, a thousandth inside", [](std::size_t n) { return circle_and_inside(n, 0.999, 14); });
  all.add("circle, half inside", [](std::size_t n) { return circle_and_inside(n, 0.5, 15); });
  all.add("two circles, one center", [](std::size_t n) { return circles(n, 2, 16); });
  all.add("ten circles, one center", [](std::size_t n) { return circles(n, 10, 17); });
  all.add("100 circles, one center", [](std::size_t n) { return circles(n, 100, 18); });
  all.each("two circles side by side", 19, [](Random& random) {
    const Point p = polar(1, random.unit());
    return random.chance(0.5) ? p : Point{p.x + 3, p.y};
  });
  all.curve("ellipse 1 : 10", 20, [](double t) { return Point{10 * polar(1, t).x, polar(1, t).y}; });
  all.curve("ellipse 1 : 1000", 21, [](double t) { return Point{1000 * polar(1, t).x, polar(1, t).y}; });
  all.curve("Lissajous", 22, [](double t) { return Point{polar(1, 3 * t).y, polar(1, 5 * t).y}; });
  all.curve("rose", 23, [](double t) { return polar(polar(1, 7 * t).x, t); });
  all.curve("figure of eight", 24, [](double t) { return Point{polar(1, t).y, polar(1, 2 * t).y}; });
  all.curve("spiral, 3 turns", 25, [](double t) { return polar(t, 3 * t); });
  all.curve("spiral, 100 turns", 26, [](double t) { return polar(t, 100 * t); });
  all.curve("logarithmic spiral", 27, [](double t) { return polar(std::exp(20 * t), 10 * t); });
  all.add("sunflower", [](std::size_t n) {
    Points points;
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<double>(i);
      points.push_back(polar(std::sqrt(k), k * (std::numbers::phi - 1)));
    }
    return points;
  });
  all.add("random walk", [](std::size_t n) { return random_walk(n, 0, 28); });
  all.add("random walk, smooth", [](std::size_t n) { return random_walk(n, 0.999, 29); });
  all.each("spokes", 30, [](Random& random) { return polar(random.unit(), random.integer(1, 100) / 100.0); });
  all.add("along three curves", [](std::size_t n) { return curves.make(n); });
  all.add("circle, line, cluster", [](std::size_t n) { return circle_line_cluster.make(n); });
}

}  // namespace rbpa_bench
