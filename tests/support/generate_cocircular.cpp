#include <cmath>
#include <cstdint>

#include "support/generate.h"

namespace rbpa_test {
namespace {

/// Returns p turned by the angle of the Pythagorean triangle (a, b, 5), times 5: integers stay integers.
rbpa::Point turned(const rbpa::Point& p, int a, int b) { return {a * p.x - b * p.y, b * p.x + a * p.y}; }

}  // namespace

Points integer_circle(int radius) {
  const std::int64_t square = std::int64_t{radius} * radius;
  Points quarter;  // from (radius, 0) up to, not including, (0, radius)
  for (std::int64_t x = radius; x > 0; --x) {
    const auto y = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(square - x * x))));
    if (x * x + y * y == square) quarter.push_back({double(x), double(y)});
  }
  Points points;
  points.reserve(4 * quarter.size());
  for (const rbpa::Point& p : quarter) points.push_back(p);
  for (const rbpa::Point& p : quarter) points.push_back({-p.y, p.x});
  for (const rbpa::Point& p : quarter) points.push_back({-p.x, -p.y});
  for (const rbpa::Point& p : quarter) points.push_back({p.y, -p.x});
  return points;
}

Points integer_concentric(int radius, bool center) {
  Points points = integer_circle(radius);
  for (const rbpa::Point& p : integer_circle(2 * radius)) points.push_back(p);
  if (center) points.push_back({0, 0});
  return points;
}

Points rounded_concentric(int each) {
  Points points;
  for (const double radius : {1.0, 1.5})
    for (int i = 0; i < each; ++i) {
      const double t = 2.0 * i / each - 1, u = 1 + t * t;  // one half of the circle, and the other by its mirror image
      const double x = radius * ((1 - t * t) / u), y = radius * (2 * t / u);
      points.push_back({i % 2 == 0 ? x : -x, y});
    }
  return points;
}

Points rectangles_of_circumradius_5(int columns) {
  Points points;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < columns; ++i) points.push_back({6.0 * i, 8.0 * j});
  return points;
}

Points triangles_3_4_5(int each, int scales) {
  constexpr int turns[][2] = {{5, 0}, {3, 4}, {-4, 3}, {0, -5}, {-3, -4}};
  Points points;
  double scale = 1, at = 0;
  for (int s = 0; s < scales; ++s, scale *= 2)
    for (int i = 0; i < each; ++i, at += 100 * scale) {
      const auto& turn = turns[i % 5];
      const double y = (i % 3) * 100 * scale;
      for (const rbpa::Point& p : {rbpa::Point{0, 0}, rbpa::Point{3, 0}, rbpa::Point{0, 4}}) {
        const rbpa::Point q = turned(p, turn[0], turn[1]);
        points.push_back({at + scale * q.x, y + scale * q.y});
      }
    }
  return points;
}

}  // namespace rbpa_test
