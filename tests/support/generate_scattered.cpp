#include <algorithm>
#include <cmath>
#include <limits>

#include "support/generate.h"
#include "support/random.h"

namespace rbpa_test {

Points uniform(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const double side = std::sqrt(static_cast<double>(count));
  Points points(count);
  for (rbpa::Point& p : points) {
    p.x = random.between(0, side);
    p.y = random.between(0, side);
  }
  return points;
}

Points jittered_grid(int columns, double jitter, std::uint64_t seed) {
  Random random(seed);
  Points points;
  points.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(columns));
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = i + 0.5 + jitter * (random.unit() - 0.5);
      const double y = j + 0.5 + jitter * (random.unit() - 0.5);
      points.push_back({x, y});
    }
  return points;
}

Points perfect_grid(int columns, double pitch) {
  Points points;
  points.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(columns));
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < columns; ++i) points.push_back({i * pitch, j * pitch});
  return points;
}

Points sparse_grid(int columns, double kept, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (const rbpa::Point& p : perfect_grid(columns, 1))
    if (random.chance(kept)) points.push_back(p);
  return points;
}

Points rotated_integer_grid(int columns) {
  Points points = perfect_grid(columns, 1);
  for (rbpa::Point& p : points) p = {3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y};
  return points;
}

Points rotated_rounded_grid(int columns) {
  constexpr double cosine = 0.95533648912560598, sine = 0.29552020666133955;
  Points points = perfect_grid(columns, 1);
  for (rbpa::Point& p : points) p = {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
  return points;
}

Points triangular_lattice(int columns) {
  constexpr double height = 0.8660254037844386;
  Points points;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < columns; ++i) points.push_back({i + (j % 2) * 0.5, j * height});
  return points;
}

Points random_grid(int columns, std::size_t count, bool repeat, std::uint64_t seed) {
  Random random(seed);
  Points points;
  if (repeat) {
    for (std::size_t i = 0; i < count; ++i) {
      const int x = random.integer(0, columns - 1), y = random.integer(0, columns - 1);
      points.push_back({double(x), double(y)});
    }
    return points;
  }
  points = perfect_grid(columns, 1);
  random.shuffle(points);
  points.resize(std::min(count, points.size()));
  return points;
}

Points clusters(std::size_t each, std::uint64_t seed) {
  Random random(seed);
  Points points;
  double radius = 1;
  for (int cluster = 0; cluster < 10; ++cluster, radius /= 10) {
    const double x = random.between(0, 10), y = random.between(0, 10);
    for (std::size_t i = 0; i < each; ++i) {
      const double dx = radius * (random.unit() - 0.5), dy = radius * (random.unit() - 0.5);
      points.push_back({x + dx, y + dy});
    }
  }
  random.shuffle(points);
  return points;
}

Points duplicates(std::size_t distinct, int most, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i < distinct; ++i) {
    const int x = random.integer(-12, 12), y = random.integer(-12, 12);
    const int copies = random.integer(1, most);
    for (int copy = 0; copy < copies; ++copy) {
      rbpa::Point p{double(x), double(y)};
      if (x == 0 && random.chance(0.5)) p.x = -0.0;
      if (y == 0 && random.chance(0.5)) p.y = -0.0;
      points.push_back(p);
    }
  }
  random.shuffle(points);
  return points;
}

Points nearest_doubles(std::size_t pairs, std::uint64_t seed) {
  Random random(seed);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Points points;
  for (const rbpa::Point& p : uniform(pairs, seed)) {
    points.push_back(p);
    const std::uint64_t which = random.below(3);
    points.push_back({which != 0 ? std::nextafter(p.x, infinity) : p.x, which != 1 ? std::nextafter(p.y, -1.0) : p.y});
  }
  random.shuffle(points);
  return points;
}

Points lidar_lines(int lines, int per_line, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (int line = 0; line < lines; ++line)
    for (int i = 0; i < per_line; ++i) {
      // A whole number of hundredths, then one division: the double nearest to the decimal, as a reader of the file
      // gets it.
      const int x = 60000000 + 11 * i + random.integer(-3, 3);
      const int y = 500000000 + 73 * line + random.integer(-2, 2) + i / 40;
      points.push_back({x / 100.0, y / 100.0});
    }
  return points;
}

Points along_curves(int per_curve) {
  Points points;
  for (int i = 0; i < per_curve; ++i) {
    const double t = 2.0 * i / per_curve - 1;
    points.push_back({t, t * t});
    points.push_back({t, 3 * t * t * t - 2 * t - 2});
    const double u = 1 + t * t;
    points.push_back({4 + (1 - t * t) / u, 2 * t / u});
  }
  return points;
}

}  // namespace rbpa_test
