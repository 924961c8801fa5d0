#include "bench/slow_generate.h"
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

Points circle_with_center(std::size_t count) {
  Points points = circles(count - 1, 1, 13);
  points.push_back({0, 0});
  return points;
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

void add_slow_curves(std::vector<SlowPath>& all) {
  const auto add = [&](const char* name, Points (*make)(std::size_t)) { all.push_back({"curve", {name, make}}); };
  add("parabola", [](std::size_t n) {
    return along(n, 1, [](double t) { return Point{2 * t - 1, (2 * t - 1) * (2 * t - 1)}; });
  });
  add("parabola, long", [](std::size_t n) {
    return along(n, 2, [](double t) { return Point{1000 * t, 1e6 * t * t}; });
  });
  add("parabola, both branches", [](std::size_t n) {
    return scattered(n, 3, [](Random& random) {
      const double x = random.between(-1, 1);
      return Point{x, random.chance(0.5) ? x * x : -x * x};
    });
  });
  add("cubic", [](std::size_t n) {
    return along(n, 4, [](double t) { return Point{2 * t - 1, std::pow(2 * t - 1, 3)}; });
  });
  add("sine, 10 periods", [](std::size_t n) {
    return along(n, 5, [](double t) { return Point{t, std::sin(20 * std::numbers::pi * t)}; });
  });
  add("sine, 1000 periods", [](std::size_t n) {
    return along(n, 6, [](double t) { return Point{t, std::sin(2000 * std::numbers::pi * t)}; });
  });
  add("exponential", [](std::size_t n) { return along(n, 7, [](double t) { return Point{t, std::exp(10 * t)}; }); });
  add("bell", [](std::size_t n) {
    return along(n, 8, [](double t) { return Point{6 * t - 3, std::exp(-(6 * t - 3) * (6 * t - 3))}; });
  });
  add("hyperbola", [](std::size_t n) { return along(n, 9, [](double t) { return Point{0.01 + t, 1 / (0.01 + t)}; }); });
  add("circle", [](std::size_t n) { return circles(n, 1, 10); });
  add("half a circle", [](std::size_t n) { return along(n, 11, [](double t) { return polar(1, t / 2); }); });
  add("circle and center", circle_with_center);
  add("circle, a thousandth inside", [](std::size_t n) { return circle_and_inside(n, 0.999, 14); });
  add("circle, half inside", [](std::size_t n) { return circle_and_inside(n, 0.5, 15); });
  add("two circles, one center", [](std::size_t n) { return circles(n, 2, 16); });
  add("ten circles, one center", [](std::size_t n) { return circles(n, 10, 17); });
  add("100 circles, one center", [](std::size_t n) { return circles(n, 100, 18); });
  add("two circles side by side", [](std::size_t n) {
    return scattered(n, 19, [](Random& random) {
      const Point p = polar(1, random.unit());
      return random.chance(0.5) ? p : Point{p.x + 3, p.y};
    });
  });
  add("ellipse 1 : 10", [](std::size_t n) {
    return along(n, 20, [](double t) { return Point{10 * polar(1, t).x, polar(1, t).y}; });
  });
  add("ellipse 1 : 1000", [](std::size_t n) {
    return along(n, 21, [](double t) { return Point{1000 * polar(1, t).x, polar(1, t).y}; });
  });
  add("Lissajous", [](std::size_t n) {
    return along(n, 22, [](double t) { return Point{polar(1, 3 * t).y, polar(1, 5 * t).y}; });
  });
  add("rose", [](std::size_t n) { return along(n, 23, [](double t) { return polar(polar(1, 7 * t).x, t); }); });
  add("figure of eight", [](std::size_t n) {
    return along(n, 24, [](double t) { return Point{polar(1, t).y, polar(1, 2 * t).y}; });
  });
  add("spiral, 3 turns", [](std::size_t n) { return along(n, 25, [](double t) { return polar(t, 3 * t); }); });
  add("spiral, 100 turns", [](std::size_t n) { return along(n, 26, [](double t) { return polar(t, 100 * t); }); });
  add("logarithmic spiral",
      [](std::size_t n) { return along(n, 27, [](double t) { return polar(std::exp(20 * t), 10 * t); }); });
  add("sunflower", [](std::size_t n) {
    Points points;
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<double>(i);
      points.push_back(polar(std::sqrt(k), k * (std::numbers::phi - 1)));
    }
    return points;
  });
  add("random walk", [](std::size_t n) { return random_walk(n, 0, 28); });
  add("random walk, smooth", [](std::size_t n) { return random_walk(n, 0.999, 29); });
  add("spokes", [](std::size_t n) {
    return scattered(n, 30, [](Random& random) { return polar(random.unit(), random.integer(1, 100) / 100.0); });
  });
  add("along three curves", [](std::size_t n) { return curves.make(n); });
  add("circle, line, cluster", [](std::size_t n) { return circle_line_cluster.make(n); });
}

}  // namespace rbpa_bench
