
#include "support/generate.h"
#include "support/random.h"

namespace rbpa_test {
namespace {

/// Returns point i of `count` on a circle around the origin, at distances that differ by up to a factor of two.
rbpa::Point on_circle(std::size_t i, std::size_t count, double radius) {
  const double t = 4.0 * static_cast<double>(i / 2) / static_cast<double>(count) - 1, u = 1 + t * t;
  const double x = radius * ((1 - t * t) / u), y = radius * (2 * t / u);
  return i % 2 == 0 ? rbpa::Point{x, y} : rbpa::Point{-x, -y};
}

}  // namespace

Points rounded_circle(std::size_t count) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(on_circle(i, count, 1));
  return points;
}

Points many_rounded_circles(std::size_t circles, std::size_t each) {
  Points points;
  for (std::size_t c = 0; c < circles; ++c)
    for (std::size_t i = 0; i < each; ++i) points.push_back(on_circle(i, each, 1 + static_cast<double>(c)));
  return points;
}

Points along_a_curve(std::size_t count) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 6 * static_cast<double>(i) / static_cast<double>(count) - 3, u = 1 + t * t;
    points.push_back({2 * t / u + 0.1 * t, 2 * t * (1 - t * t) / (u * u) + 0.05 * t * t});
  }
  return points;
}

Points circle_line_and_cluster(std::size_t each, std::uint64_t seed) {
  Random random(seed);
  Points points = rounded_circle(each);
  for (std::size_t i = 0; i < each; ++i)
    points.push_back({3 * static_cast<double>(i) / static_cast<double>(each) - 1, 1.5});
  for (std::size_t i = 0; i < each; ++i) {
    const double dx = 1e-12 * random.unit(), dy = 1e-12 * random.unit();
    points.push_back({0.25 + dx, 0.125 + dy});
  }
  return points;
}

}  // namespace rbpa_test
