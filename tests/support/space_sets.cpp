#include "support/space_sets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/vectors.h"

namespace rbpa_test {
namespace {

using rbpa::Point3;

Point3 in_cube(Random& random) { return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}; }

Point3 direction(Random& random) {
  while (true) {
    const Point3 p = in_cube(random);
    const double size = length(p);
    if (size > 0.1 && size <= 1) return (1 / size) * p;
  }
}

Point3 on_grid(int columns, Random& random) {
  return {double(random.integer(0, columns)), double(random.integer(0, columns)), double(random.integer(0, columns))};
}

/// Returns all integer points at a distance whose square is given.
Points3 integer_sphere(int square) {
  Points3 points;
  const int most = static_cast<int>(std::sqrt(square));
  for (int x = -most; x <= most; ++x)
    for (int y = -most; y <= most; ++y)
      for (int z = -most; z <= most; ++z)
        if (x * x + y * y + z * z == square) points.push_back({double(x), double(y), double(z)});
  return points;
}

Point3 one(SpaceKind kind, Random& random) {
  const auto small = [&] { return double(random.integer(-3, 3)); };
  switch (kind) {
    case SpaceKind::grid:
      return on_grid(3, random);
    case SpaceKind::near_sphere:
      return direction(random);
    case SpaceKind::plane: {
      const double i = small(), j = small();
      return i * Point3{1, 2, -1} + j * Point3{3, 0, 1};
    }
    case SpaceKind::plane_grid:
      return {small(), small(), 1};
    case SpaceKind::line:
      return double(random.integer(-9, 9)) * Point3{1, -2, 3};
    case SpaceKind::line_and_few:
      return random.chance(0.6) ? double(random.integer(-4, 4)) * Point3{1, 0, 1} : on_grid(3, random);
    case SpaceKind::plate:
      return {random.between(-1, 1), random.between(-1, 1), random.chance(0.5) ? 0.01 : 0.0};
    case SpaceKind::noisy_sphere:
      return (1 + random.between(-0.2, 0.2)) * direction(random);
    case SpaceKind::clusters:
      return double(random.integer(0, 2)) * Point3{1, 1, 0} +
             std::ldexp(1.0, -5 * random.integer(0, 4)) * in_cube(random);
    default:
      return in_cube(random);
  }
}

}  // namespace

std::string name(SpaceKind kind) {
  static constexpr std::array names = {"cube",       "grid",    "cospherical",  "near_sphere", "plane",
                                       "plane_grid", "line",    "line_and_few", "plate",       "noisy_sphere",
                                       "clusters",   "nearest", "extreme"};
  static_assert(names.size() == space_kinds);
  return names[static_cast<std::size_t>(kind)];
}

Points3 space_set(SpaceKind kind, std::size_t count, Random& random) {
  Points3 points;
  if (kind == SpaceKind::cospherical) {
    static constexpr std::array squares = {3, 5, 9, 14, 29, 41, 81};
    Points3 sphere = integer_sphere(squares[random.below(squares.size())]);
    random.shuffle(sphere);
    sphere.resize(std::min(sphere.size(), count));
    if (random.chance(0.5)) sphere.push_back({0, 0, 0});
    return sphere;
  }
  if (kind == SpaceKind::nearest) {
    while (points.size() < count) {
      const Point3 p = on_grid(2, random) + Point3{1, 1, 1};
      points.push_back(p);
      points.push_back({p.x, std::nextafter(p.y, random.chance(0.5) ? 9 : -9), std::nextafter(p.z, 9)});
    }
    return points;
  }
  if (kind == SpaceKind::extreme) {
    const auto inner = static_cast<SpaceKind>(random.integer(0, 3));
    points = space_set(inner, count, random);
    const int scale = random.integer(-1, 1);  // -1 and 1: all; 0: both
    for (Point3& p : points) p = (scale > 0 || (scale == 0 && random.chance(0.5)) ? 0x1p500 : 0x1p-500) * p;
    return points;
  }
  while (points.size() < count) points.push_back(one(kind, random));
  if (random.chance(0.3) && !points.empty())
    for (int i = 0; i < 3; ++i) points.push_back(points[random.below(points.size())]);
  return points;
}

double space_radius(const Points3& points, Random& random) {
  const auto any = [&] { return points[random.below(points.size())]; };
  static constexpr std::array ties = {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.5, 5.0, 9.0};
  double radius = 0;
  if (points.size() >= 4 && random.chance(0.7)) {
    const Point3 a = any(), u = any() - a, v = any() - a, w = any() - a;
    const double volume = dot(cross(u, v), w), area = length(cross(u, v));
    if (random.chance(0.2))
      radius = length(u) / 2;
    else if (random.chance(0.5))
      radius = length(u) * length(v) * length(u - v) / (2 * area);
    else
      radius =
          length(dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v)) / (2 * std::abs(volume));
  }
  if (!(radius > 0) || std::isinf(radius))
    radius = random.chance(0.6) ? ties[random.below(ties.size())] : std::exp2(random.between(-6, 4));
  return random.chance(0.2) ? std::nextafter(radius, random.chance(0.5) ? 0 : 2 * radius) : radius;
}

Points3 corners_of_bricks(int columns, int rows, int layers, const Point3& size) {
  Points3 points;
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < rows; ++y)
      for (int z = 0; z < layers; ++z) points.push_back({size.x * x, size.y * y, size.z * z});
  return points;
}

Points3 random_normals(std::size_t count, Random& random) {
  Points3 normals;
  while (normals.size() < count) {
    const Point3 n = random.chance(0.5) ? direction(random) : on_grid(2, random) - on_grid(2, random);
    if (n != Point3{}) normals.push_back(n);
  }
  return normals;
}

}  // namespace rbpa_test
