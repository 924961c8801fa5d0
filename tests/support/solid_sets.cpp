#include "support/solid_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/vectors.h"

namespace rbpa_test {
namespace {

using rbpa::Point3;

template <typename Make>
Points3 generate(std::size_t count, std::uint64_t seed, Make make) {
  Random random(seed);
  Points3 points;
  while (points.size() < count) points.push_back(make(random));
  return points;
}

Point3 anywhere(Random& random) { return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}; }

Point3 on_sphere(Random& random) {
  while (true) {
    const Point3 p = anywhere(random);
    const double size = length(p);
    if (size > 0.1 && size <= 1) return 1 / size * p;
  }
}

int columns_for(std::size_t count) { return static_cast<int>(std::lround(std::cbrt(static_cast<double>(count)))); }

Points3 shuffled(Points3 points, std::uint64_t seed) {
  Random random(seed);
  random.shuffle(points);
  return points;
}

Points3 body_centered(std::size_t count) {
  Points3 points;
  const int columns = columns_for(count / 2);
  for (const Point3& p : cubic_grid(count / 2, 2, 1)) {
    points.push_back(p);
    if (p.x < 2 * columns - 2 && p.y < 2 * columns - 2 && p.z < 2 * columns - 2)
      points.push_back({p.x + 1, p.y + 1, p.z + 1});
  }
  return points;
}

/// Returns integer points of several spheres around one center.
Points3 shells(std::size_t count) {
  Points3 points;
  for (int square = 9; points.size() < count; square += 20)
    for (int x = -square; x <= square; ++x)
      for (int y = -square; y <= square; ++y) {
        const int rest = square - x * x - y * y;
        if (rest < 0) continue;
        const int z = static_cast<int>(std::lround(std::sqrt(rest)));
        if (z * z != rest) continue;
        points.push_back({double(x), double(y), double(z)});
        if (z != 0) points.push_back({double(x), double(y), double(-z)});
      }
  return points;
}

Points3 scaled(Points3 points, double factor) {
  for (Point3& p : points) p = factor * p;
  return points;
}

}  // namespace

Points3 uniform_cube(std::size_t count, std::uint64_t seed) {
  const double half = std::cbrt(static_cast<double>(count)) / 2;
  return generate(count, seed, [&](Random& random) { return half * anywhere(random); });
}

Points3 jittered_cubes(std::size_t count, std::uint64_t seed) {
  Points3 points = cubic_grid(count, 1, seed);
  Random random(seed);
  for (Point3& p : points)
    p = {p.x + random.between(0, 0.5), p.y + random.between(0, 0.5), p.z + random.between(0, 0.5)};
  return points;
}

Points3 cubic_grid(std::size_t count, double pitch, std::uint64_t seed) {
  Points3 points;
  const int columns = columns_for(count);
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < columns; ++y)
      for (int z = 0; z < columns; ++z) points.push_back({pitch * x, pitch * y, pitch * z});
  return shuffled(std::move(points), seed);
}

Points3 turned_grid(std::size_t count, std::uint64_t seed) {
  // The rotation by the quaternion (a, b, c, d), times the square of its norm.
  constexpr double a = 1201, b = 877, c = -1409, d = 463;
  Points3 points = cubic_grid(count, 1, seed);
  for (Point3& p : points)
    p = {(a * a + b * b - c * c - d * d) * p.x + 2 * (b * c - a * d) * p.y + 2 * (b * d + a * c) * p.z,
         2 * (b * c + a * d) * p.x + (a * a - b * b + c * c - d * d) * p.y + 2 * (c * d - a * b) * p.z,
         2 * (b * d - a * c) * p.x + 2 * (c * d + a * b) * p.y + (a * a - b * b - c * c + d * d) * p.z};
  return points;
}

Points3 moved_lattice(std::size_t count, Random& random) {
  const std::size_t width = 2 + random.below(6);
  const double noise = std::pow(10.0, -static_cast<double>(random.below(20)));
  const auto coordinate = [&] {
    const auto at = static_cast<double>(random.below(width));
    return at + (random.below(3) != 0 ? 0 : noise * (random.unit() - 0.5));
  };
  Points3 points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.push_back({x, y, z});
  }
  return points;
}

Points3 clusters_in_cube(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Points3 points;
  const std::size_t each = std::min<std::size_t>(1000, count / 9 + 1);
  for (int decade = 1; points.size() < count; decade = decade % 9 + 1) {
    const Point3 center = anywhere(random);
    const double size = std::pow(0.1, decade);
    for (std::size_t i = 0; i < each && points.size() < count; ++i) {
      const Point3 p = anywhere(random);
      points.push_back({center.x + size * p.x, center.y + size * p.y, center.z + size * p.z});
    }
  }
  return shuffled(std::move(points), seed);
}

Points3 on_unit_sphere(std::size_t count, std::uint64_t seed) { return generate(count, seed, on_sphere); }

Points3 moment_curve(std::size_t count) {
  Points3 points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    points.push_back({t, t * t, t * t * t});
  }
  return points;
}

std::vector<SolidSet> solid_sets(std::size_t count) {
  const std::size_t few = std::min<std::size_t>(count, 400);  // for shapes with a quadratic number of tetrahedra
  std::vector<SolidSet> sets;
  sets.push_back({"cube", uniform_cube(count, 1)});
  sets.push_back({"ball", generate(count, 2, [](Random& r) { return std::cbrt(r.unit()) * on_sphere(r); })});
  sets.push_back({"sphere", on_unit_sphere(count, 3)});
  sets.push_back({"two spheres", generate(count, 4, [](Random& r) {
                    const double radius = r.chance(0.5) ? 1 : 2;
                    return radius * on_sphere(r);
                  })});
  sets.push_back({"slab", generate(count, 5, [](Random& r) {
                    const Point3 p = anywhere(r);
                    return Point3{p.x, p.y, 0.001 * p.z};
                  })});
  sets.push_back({"line and few", generate(few, 6, [](Random& r) {
                    const double t = r.between(-9, 9);
                    return r.chance(0.9) ? Point3{t, t, 0} : anywhere(r);
                  })});
  sets.push_back({"two lines", generate(few, 7, [](Random& r) {
                    const double t = r.between(-1, 1);
                    return r.chance(0.5) ? Point3{t, 0, 0} : Point3{0, t, 1};
                  })});
  sets.push_back({"moment curve", moment_curve(few)});
  sets.push_back({"helix", generate(few, 8, [](Random& r) {
                    const double t = r.between(0, 30);
                    return Point3{std::cos(t), std::sin(t), t / 10};
                  })});
  sets.push_back({"integer grid", cubic_grid(count, 1, 9)});
  sets.push_back({"grid of tenths", cubic_grid(count, 0.1, 10)});
  sets.push_back({"turned grid", turned_grid(count, 19)});
  sets.push_back({"body-centered grid", body_centered(count)});
  sets.push_back({"jittered grid", jittered_cubes(count, 11)});
  sets.push_back({"cospherical shells", shells(count)});
  sets.push_back({"clusters", clusters_in_cube(count, 12)});
  sets.push_back({"duplicates", generate(count, 13, [](Random& r) {
                    return Point3{double(r.integer(0, 5)), double(r.integer(0, 5)),
                                  r.chance(0.3) ? -0.0 : double(r.integer(0, 3))};
                  })});
  sets.push_back({"plane",
                  generate(count, 14,
                           [](Random& r) {
                             const double i = r.integer(-50, 50), j = r.integer(-50, 50);
                             return Point3{i + 3 * j, 2 * i, j - i};
                           }),
                  false});
  sets.push_back({"planes", generate(count, 15, [](Random& r) {
                    return Point3{double(r.integer(0, 30)), double(r.integer(0, 30)), double(r.integer(0, 1))};
                  })});
  sets.push_back({"cube at 1e100", scaled(uniform_cube(count, 16), 1e100)});
  sets.push_back({"grid at 1e-100", scaled(cubic_grid(count, 1, 17), 1e-100)});
  const auto mixed = [](Random& r) { return std::array{1e100, 1.0, 1e-100}[r.below(3)] * anywhere(r); };
  sets.push_back({"1e100, 1 and 1e-100", generate(std::min<std::size_t>(count, 150), 18, mixed)});
  return sets;
}

}  // namespace rbpa_test
