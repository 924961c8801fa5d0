#include "bench/workload.h"

#include <cmath>
#include <numbers>

#include "support/generate.h"
#include "support/random.h"

namespace rbpa_bench {
namespace {

using rbpa_test::Points;
using rbpa_test::Random;

int columns(std::size_t count) { return static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))); }

/// Returns points in random directions, at distances given by the share of points below them.
template <typename Distance>
Points round_about(std::size_t count, std::uint64_t seed, Distance distance) {
  Random random(seed);
  Points points;
  points.reserve(count);
  while (points.size() < count) {
    const double r = distance(random.unit()), angle = 2 * std::numbers::pi * random.unit();
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

/// Returns points on one circle around the origin, in any order.
Points on_circle(std::size_t count, double radius, std::uint64_t seed) {
  return round_about(count, seed, [radius](double) { return radius; });
}

Points three_traps(std::size_t count) {
  Points points = on_circle(count / 3, 1, 10);
  Random random(11);
  for (std::size_t i = 0; i < count / 3; ++i) points.push_back({random.between(-2, 2), 0.25});
  for (std::size_t i = 0; i < count / 3; ++i) {
    const double x = 0.5 + 1e-12 * random.unit(), y = 0.5 + 1e-12 * random.unit();
    points.push_back({x, y});
  }
  random.shuffle(points);
  return points;
}

Points ten_circles(std::size_t count) {
  Points points;
  for (int i = 1; i <= 10; ++i)
    for (const rbpa::Point& p : on_circle(count / 10, i / 10.0, 12 + static_cast<std::uint64_t>(i)))
      points.push_back(p);
  Random(12).shuffle(points);
  return points;
}

}  // namespace

Points gaussian_clusters(std::size_t count, double width_decades) {
  Random random(4);
  Points points;
  points.reserve(count);
  for (int cluster = 0; cluster < 100; ++cluster) {
    const double x = random.unit(), y = random.unit(), width = 0.05 * std::pow(10, -width_decades * random.unit());
    for (const rbpa::Point& p : round_about(count / 100, 5 + static_cast<std::uint64_t>(cluster),
                                            [](double u) { return std::sqrt(-2 * std::log(1 - u)); }))
      points.push_back({x + width * p.x, y + width * p.y});
  }
  random.shuffle(points);
  return points;
}

const Workload uniform{"uniform", [](std::size_t count) { return rbpa_test::uniform(count, 1); }};
const Workload jittered{"jittered", [](std::size_t count) { return rbpa_test::jittered_grid(columns(count), 0.9, 2); }};
const Workload grid{"grid", [](std::size_t count) { return rbpa_test::perfect_grid(columns(count), 1); }};
const Workload clusters{"clusters", [](std::size_t count) { return gaussian_clusters(count, 3); }};
const Workload kuzmin{"Kuzmin", [](std::size_t count) {
                        // The outermost 10⁻⁶ of the points are cut off, because their distances have no bound.
                        return round_about(count, 6, [](double u) {
                          const double rest = 1 - u * (1 - 1e-6);
                          return std::sqrt(1 / (rest * rest) - 1);
                        });
                      }};
const Workload lidar{"lidar lines",
                     [](std::size_t count) { return rbpa_test::lidar_lines(columns(count), columns(count), 7); }};
const Workload decades{"three decades", [](std::size_t count) {
                         return round_about(count, 8, [](double u) { return std::pow(10, 3 * u); });
                       }};

const Workload circle{"circle", [](std::size_t count) { return on_circle(count, 1, 10); }};
const Workload circle_line_cluster{"circle, line, cluster", three_traps};
const Workload curves{"curves", [](std::size_t count) { return rbpa_test::along_curves(static_cast<int>(count / 3)); }};
const Workload concentric{"concentric circles", ten_circles};

double spacing_along_curves(const Points& points) {
  constexpr std::size_t taking_turns = 3;  // one point of each of the three curves in turn
  double sum = 0;
  for (std::size_t i = taking_turns; i < points.size(); ++i)
    sum += std::hypot(points[i].x - points[i - taking_turns].x, points[i].y - points[i - taking_turns].y);
  return sum / static_cast<double>(points.size() - taking_turns);
}

Points two_level_sampling(std::size_t count) {
  Random random(9);
  Points points;
  // Jittered rows in two squares side by side, the pitch of the second twice that of the first.
  const double pitch = std::sqrt(2 / static_cast<double>(count));
  for (const double scale : {1.0, 2.0})
    for (double y = 0; y < scale; y += scale * pitch)
      for (double x = scale - 1; x < 2 * scale - 1; x += scale * pitch)
        points.push_back({x + 0.4 * scale * pitch * random.unit(), y + 0.4 * scale * pitch * random.unit()});
  return points;
}

}  // namespace rbpa_bench
