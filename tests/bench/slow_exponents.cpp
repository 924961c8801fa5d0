#include <algorithm>

#include "bench/slow_paths.h"

namespace rbpa_bench {
namespace {

using rbpa::Point;

/// Returns thirty times the mean distance of neighbors along x.
double thirty_along_x(const Points& points) {
  const auto [least, most] =
      std::minmax_element(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  return 30 * (most->x - least->x) / static_cast<double>(points.size());
}

double one(const Points&) { return 1; }
constexpr std::size_t strangers = 100;

double far_apart(const Points&) { return 2.7e180; }

Points bell_and_tails(std::size_t count) {
  return along(count, 110, [](double t) {
    const double x = 18 * t - 9;
    return Point{x, std::exp(-x * x)};
  });
}

Points tiny_parabola(std::size_t count) {
  return rbpa_test::scaled(along(count, 111,
                                 [](double t) {
                                   return Point{2 * t - 1, (2 * t - 1) * (2 * t - 1)};
                                 }),
                           -200);
}

Points tiny_circle(std::size_t count) {
  return rbpa_test::scaled(along(count, 112, [](double t) { return polar(1, t); }), -200);
}

Points powers_of_ten(std::size_t count) {
  return scattered(count, 113, [](Random& random) {
    const double x = std::pow(10, random.between(-150, 150));
    return Point{x, std::pow(10, random.between(-150, 150))};
  });
}

Points uniform_and(std::size_t count, Point stranger) {
  Points points = uniform.make(count - 1);
  points.push_back(stranger);
  return points;
}

}  // namespace

std::vector<SlowPath> slow_paths() {
  SlowPaths all;
  add_slow_curves(all);
  add_slow_dust(all);
  add_slow_rows(all);
  all.kind = "exponents";
  all.max_rbpa = all.max_hrbpa = 2;
  const char* along_x = "30 spacings";
  all.add("(x, exp(−x²)), x within ±9", bell_and_tails);
  all.add("(x, exp(−x²)), x within ±9", bell_and_tails, along_x, thirty_along_x);
  all.add("(x, x²) · 2⁻²⁰⁰", tiny_parabola);
  all.add("(x, x²) · 2⁻²⁰⁰", tiny_parabola, along_x, thirty_along_x);
  all.add("circle · 2⁻²⁰⁰", tiny_circle);
  all.add("circle · 2⁻²⁰⁰", tiny_circle, along_x, thirty_along_x);
  all.add("10ᵘ, u within ±150", powers_of_ten);
  all.add("10ᵘ, u within ±150", powers_of_ten, "2.7e180", far_apart);
  const auto at_1e60 = [](std::size_t n) { return uniform_and(n, {1e60, 0}); };
  const auto at_1e_40 = [](std::size_t n) { return uniform_and(n, {0.5, 1e-40}); };
  all.add("uniform and (1e60, 0)", at_1e60);
  all.add("uniform and (1e60, 0)", at_1e60, "1 spacing", one);
  all.add("uniform and (0.5, 1e-40)", at_1e_40);
  all.add("uniform and (0.5, 1e-40)", at_1e_40, "1 spacing", one);
  all.add("uniform · 2²⁰⁰", [](std::size_t n) { return rbpa_test::scaled(uniform.make(n), 200); });
  all.add("uniform · 2⁻²⁰⁰", [](std::size_t n) { return rbpa_test::scaled(uniform.make(n), -200); });
  all.add("uniform and a hundred strangers", [](std::size_t n) {
    return rbpa_test::with_strangers(n - std::min(n / 2, strangers), std::min(n / 2, strangers), 114);
  });
  all.add("three exponents", [](std::size_t n) { return rbpa_test::mixed_exponents(n * 4 / 13, 115); });
  all.add("denormals", [](std::size_t n) { return rbpa_test::denormals(2 * columns_for(n), n, 116); });
  return all.list;
}

}  // namespace rbpa_bench
