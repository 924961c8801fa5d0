#include "bench/surface_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

#include "support/random.h"
#include "support/vectors.h"

namespace rbpa_bench {
namespace {

using namespace rbpa_test;
using rbpa::Point3;

constexpr double pi = std::numbers::pi, moved = 0.2;

Point3 any(double size, Random& random) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

/// One of the two tori, around an axis through `center` on the x axis.
struct Torus {
  static constexpr double wide = 1, tube = 0.35;
  double center;

  Point3 at(double around, double turn) const {
    const double out = wide + tube * std::cos(turn);
    return {center + out * std::cos(around), out * std::sin(around), tube * std::sin(turn)};
  }
  /// Returns the distance from the torus, negative inside, with its gradient.
  double distance(const Point3& p, Point3& gradient) const {
    const double x = p.x - center, flat = std::hypot(x, p.y), out = flat - wide, far = std::hypot(out, p.z);
    gradient = {out / far * x / flat, out / far * p.y / flat, p.z / far};
    return far - tube;
  }
};
constexpr std::array<Torus, 2> tori = {Torus{-1}, Torus{1}};

/// Returns 0 on the common surface: the lesser distance, rounded where both are similar.
double both(const Point3& p, Point3& gradient) {
  constexpr double sharp = 12;
  std::array<Point3, 2> slope;
  const double one = tori[0].distance(p, slope[0]), other = tori[1].distance(p, slope[1]);
  const double weight = 1 / (1 + std::exp(sharp * (one - other)));
  gradient = weight * slope[0] + (1 - weight) * slope[1];
  const double least = std::min(one, other);
  return least - std::log(std::exp(-sharp * (one - least)) + std::exp(-sharp * (other - least))) / sharp;
}

/// Filter that keeps points that are not too near to one that was kept before.
class Thinning {
 public:
  explicit Thinning(double distance) : distance_(distance) {}
  bool keep(const Point3& p) {
    const std::array<std::int64_t, 3> cell = {number(p.x), number(p.y), number(p.z)};
    for (std::int64_t x = cell[0] - 1; x <= cell[0] + 1; ++x)
      for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y)
        for (std::int64_t z = cell[2] - 1; z <= cell[2] + 1; ++z)
          for (auto [at, end] = kept_.equal_range(key(x, y, z)); at != end; ++at) {
            const Point3 d = at->second + -1 * p;
            if (dot(d, d) < distance_ * distance_) return false;
          }
    kept_.emplace(key(cell[0], cell[1], cell[2]), p);
    return true;
  }

 private:
  std::int64_t number(double x) const { return static_cast<std::int64_t>(std::floor(x / distance_)); }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto bits = [](std::int64_t i) { return static_cast<std::uint64_t>(i + (1 << 20)); };
    return bits(x) << 42 | bits(y) << 21 | bits(z);
  }
  double distance_;
  std::unordered_multimap<std::uint64_t, Point3> kept_;  // by cell
};

SurfacePoints with_spacing(double spacing) {
  Random random(2);
  SurfacePoints samples{"double torus", {}, {}, spacing};
  Thinning thinning(spacing / 2);
  for (std::size_t t = 0; t < 2; ++t) {
    const double rings = std::round(2 * pi * Torus::tube / spacing);
    for (double ring = 0; ring < rings; ++ring) {
      const double turn = 2 * pi * ring / rings;
      const double steps = std::round(2 * pi * (Torus::wide + Torus::tube * std::cos(turn)) / spacing);
      for (double step = 0; step < steps; ++step) {
        Point3 p = tori[t].at(2 * pi * (step + std::fmod(ring, 2) / 2) / steps, turn) + any(moved * spacing, random), n;
        const double to_other = tori[1 - t].distance(p, n);
        if (to_other < 0) continue;  // inside the other torus
        for (int times = 0; times < 6; ++times) {
          const double value = both(p, n);
          p = p + -value / dot(n, n) * n;
        }
        if (to_other < 0.3 && !thinning.keep(p)) continue;
        samples.points.push_back(p);
        samples.normals.push_back(1 / std::sqrt(dot(n, n)) * n);
      }
    }
  }
  return samples;
}

}  // namespace

SurfacePoints on_sphere(std::size_t count, double noise) {
  Random random(1);
  const auto n = static_cast<double>(count);
  const double spacing = std::sqrt(4 * pi / n);
  SurfacePoints samples{noise > 0 ? "sphere, noise" : "sphere", {}, {}, spacing};
  samples.points.reserve(count);
  samples.normals.reserve(count);
  for (double i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1) / n, ring = std::sqrt(1 - z * z), turn = i * pi * (3 - std::sqrt(5));
    Point3 p = Point3{ring * std::cos(turn), ring * std::sin(turn), z} + any(moved * spacing, random);
    p = 1 / std::sqrt(dot(p, p)) * p;
    samples.points.push_back((1 + noise * spacing * random.between(-1, 1)) * p);
    samples.normals.push_back(p);
  }
  return samples;
}

SurfacePoints on_double_torus(std::size_t count) {
  // Their number is proportional to the area, which a coarse sample estimates.
  constexpr double coarse = 0.02;
  const double area = static_cast<double>(with_spacing(coarse).points.size()) * coarse * coarse;
  return with_spacing(std::sqrt(area / static_cast<double>(count)));
}

SurfacePoints on_scan_lines(std::size_t count) {
  constexpr double denser = 20, tube = 0.5;
  // Rings of length 2 pi out around the axis, with points pi / lines / denser apart.
  const double lines = std::round(std::sqrt(static_cast<double>(count) / (2 * denser))),
               spacing = 2 * pi * tube / lines;
  SurfacePoints samples{"scan lines", {}, {}, spacing};
  for (double line = 0; line < lines; ++line) {
    const double turn = 2 * pi * line / lines, out = 1 + tube * std::cos(turn);
    const double along = std::round(2 * pi * out * denser / spacing);
    for (double i = 0; i < along; ++i) {
      const double around = 2 * pi * (i + 0.37 * line) / along;
      samples.points.push_back({out * std::cos(around), out * std::sin(around), tube * std::sin(turn)});
      samples.normals.push_back({std::cos(around) * std::cos(turn), std::sin(around) * std::cos(turn), std::sin(turn)});
    }
  }
  return samples;
}

SurfacePoints with_outliers(std::size_t count) {
  SurfacePoints samples = on_sphere(count - count / 20, 0);
  samples.name = "sphere, outliers";
  Random random(3);
  while (samples.points.size() < count) {
    samples.points.push_back(any(4, random));
    samples.normals.push_back(any(1, random));
  }
  return samples;
}

SurfacePoints on_street(std::size_t count) {
  Random random(4);
  constexpr double near = 1, far = 60, facade = 8, height = 6;
  SurfacePoints samples{"street", {}, {}, far * std::sqrt(2 * pi * std::log(far / near) / static_cast<double>(count))};
  while (samples.points.size() < count) {
    // Directions of a scanner are even, so that density falls with the square of the distance.
    const double distance = near * std::pow(far / near, random.unit()), angle = random.between(0, 2 * pi);
    Point3 p = {distance * std::cos(angle), distance * std::sin(angle), random.between(-0.02, 0.02)}, n = {0, 0, 1};
    if (std::abs(p.y) > facade) {  // the point at which the ray meets the facade
      const double share = facade / std::abs(p.y);
      p = {p.x * share, std::copysign(facade, p.y) + random.between(-0.02, 0.02), height * random.unit()};
      n = {0, -std::copysign(1.0, p.y), 0};
    }
    samples.points.push_back(p);
    samples.normals.push_back(n);
  }
  return samples;
}

SurfacePoints on_grid(std::size_t count) {
  const int side = static_cast<int>(std::cbrt(static_cast<double>(count)) + 0.5);
  SurfacePoints samples{"grid", {}, {}, 1};
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        samples.points.push_back({double(x), double(y), double(z)});
        samples.normals.push_back({2.0 * x - side, 2.0 * y - side, 2.0 * z - side + 0.5});
      }
  return samples;
}

SurfacePoints ten_times(std::size_t count) {
  const SurfacePoints once = on_sphere(count / 10, 0);
  SurfacePoints samples{"sphere, ten times", {}, {}, once.spacing};
  for (int times = 0; times < 10; ++times) {
    samples.points.insert(samples.points.end(), once.points.begin(), once.points.end());
    samples.normals.insert(samples.normals.end(), once.normals.begin(), once.normals.end());
  }
  return samples;
}

}  // namespace rbpa_bench
