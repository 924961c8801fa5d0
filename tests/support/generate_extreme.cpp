#include <cmath>
#include <limits>

#include "support/generate.h"
#include "support/random.h"

namespace rbpa_test {

Points scaled(Points points, int exponent) {
  for (rbpa::Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  return points;
}

Points moved(Points points, double dx, double dy) {
  for (rbpa::Point& p : points) p = {p.x + dx, p.y + dy};
  return points;
}

Points mixed_exponents(std::size_t each, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (const double scale : {1e300, 1.0, 1e-300})
    for (std::size_t i = 0; i < each; ++i) {
      const double x = scale * (random.unit() - 0.5), y = scale * (random.unit() - 0.5);
      points.push_back({x, y});
    }
  for (std::size_t i = 0; i < each / 4; ++i) {  // both exponents in one point
    const double x = 1e300 * (random.unit() - 0.5), y = 1e-300 * (random.unit() - 0.5);
    points.push_back(random.chance(0.5) ? rbpa::Point{x, y} : rbpa::Point{y, x});
  }
  random.shuffle(points);
  return points;
}

Points denormals(int columns, std::size_t count, std::uint64_t seed) {
  Points points = random_grid(columns, count, false, seed);
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  for (rbpa::Point& p : points) p = {p.x * smallest, p.y * smallest};
  return points;
}

Points corners_of_range() {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  Points points;
  for (const double x : {-most, -most / 2, -1.0, -least, 0.0, least, 1.0, most / 2, most})
    for (const double y : {-most, -1.0, 0.0, least, 1.0, most}) points.push_back({x, y});
  return points;
}

Points far_and_tiny(std::size_t each, std::uint64_t seed) {
  Random random(seed);
  Points points;
  // Only near an axis can a point have a tiny and a huge coordinate.
  for (const rbpa::Point& at :
       {rbpa::Point{0, 0}, rbpa::Point{1e300, 0}, rbpa::Point{0, 1e300}, rbpa::Point{-1e300, 0}})
    for (std::size_t i = 0; i < each; ++i) {
      const double x = at.x + 1e-300 * (random.unit() - 0.5), y = at.y + 1e-300 * (random.unit() - 0.5);
      points.push_back({x, y});
    }
  random.shuffle(points);
  return points;
}

Points with_strangers(std::size_t count, std::size_t strangers, std::uint64_t seed) {
  Random random(seed);
  Points points = uniform(count, seed);
  const double side = std::sqrt(static_cast<double>(count));
  for (std::size_t i = 0; i < strangers; ++i) {
    const double far = std::ldexp(1 + random.unit(), random.integer(310, 900)) * (random.chance(0.5) ? 1 : -1),
                 fine = std::ldexp(1 + random.unit(), random.integer(-1000, -360)), near = side * random.unit();
    switch (random.below(4)) {
      case 0:
        points.push_back({far, near});
        break;
      case 1:
        points.push_back({near, far});
        break;
      case 2:
        points.push_back({near, fine});
        break;
      default:
        points.push_back({fine, near});
    }
    if (random.chance(0.2)) points.push_back(points.back());
  }
  random.shuffle(points);
  return points;
}

}  // namespace rbpa_test
