#include <cmath>

#include "support/generate.h"
#include "support/random.h"

namespace rbpa_test {

Points tiny_components(int components, std::uint64_t seed) {
  Random random(seed);
  const int columns = static_cast<int>(std::sqrt(components)) + 1;
  Points points;
  for (int component = 0; component < components; ++component) {
    const double x = 100.0 * (component % columns), y = 100.0 * (component / columns);
    const int corners = random.integer(2, 4);
    if (corners == 4 && random.chance(0.5)) {  // a unit square: two triangles whose circle is the same
      for (const rbpa::Point& p : {rbpa::Point{0, 0}, rbpa::Point{1, 0}, rbpa::Point{1, 1}, rbpa::Point{0, 1}})
        points.push_back({x + p.x, y + p.y});
      continue;
    }
    for (int corner = 0; corner < corners; ++corner) {
      const double dx = random.unit(), dy = random.unit();
      points.push_back({x + dx, y + dy});
    }
  }
  random.shuffle(points);
  return points;
}

Points chain_of_triangles(int length) {
  Points points = {{0, 0}};
  for (int i = 0; i < length; ++i) {
    points.push_back({4.0 * i + 2, i % 2 == 0 ? 3.0 : -3.0});
    points.push_back({4.0 * i + 4, 0});
  }
  return points;
}

Points ring_of_pinches(int length) {
  // Each half step turns by the angle of tangent 2t / (1 − t²), about π / length, so that the ring closes except for a
  // gap that is far smaller than a triangle. The chord of a whole step is 4, as in the chain.
  const double t = 3.141592653589793 / (2.0 * length);
  const double cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
  const double radius = 2 / sine;
  Points points;
  double x = 1, y = 0;
  for (int i = 0; i < length; ++i) {
    const auto turn = [&] {
      const double turned_x = cosine * x - sine * y;
      y = sine * x + cosine * y;
      x = turned_x;
    };
    points.push_back({radius * x, radius * y});
    turn();
    const double apex = radius * cosine + (i % 2 == 0 ? 3 : -3);
    points.push_back({apex * x, apex * y});
    turn();
  }
  return points;
}

Points pairs_at_distance_2(int pairs, std::uint64_t seed) {
  Random random(seed);
  constexpr double infinity = 1e9;
  Points points;
  for (int i = 0; i < pairs; ++i) {
    const double x = 16.0 * (i % 16), y = 16.0 * (i / 16);
    const bool upright = random.chance(0.5);
    points.push_back(upright ? rbpa::Point{x, y - 1} : rbpa::Point{x - 1, y});
    points.push_back(upright ? rbpa::Point{x, y + 1} : rbpa::Point{x + 1, y});
    const double side = random.chance(0.5) ? 1 : -1;
    double away = side;
    switch (random.below(4)) {
      case 0:
        continue;  // an edge of length exactly 2 alpha and no triangle
      case 1:
        break;  // circumradius exactly alpha
      case 2:
        away = std::nextafter(side, side * infinity);
        break;  // a little more
      default:
        away = std::nextafter(side, 0.0);  // obtuse: more as well
    }
    points.push_back(upright ? rbpa::Point{x + away, y} : rbpa::Point{x, y + away});
  }
  return points;
}

Points star(int radius) {
  Points points = integer_circle(radius);
  points.push_back({0, 0});
  return points;
}

}  // namespace rbpa_test
