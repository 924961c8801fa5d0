#include "bench/contest.h"

#include <chrono>
#include <cmath>
#include <numbers>

#include "rbpa/hrbpa.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"
#include "support/random.h"

namespace rbpa_bench {
namespace {

Run timed(std::span<const rbpa::Point> points, double alpha, rbpa::Search search) {
  const auto start = std::chrono::steady_clock::now();
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, alpha, {.search = search, .progress = {}});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return {seconds.count(), complex.mesh.n_faces()};
}

int columns(std::size_t count) { return static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))); }

/// At a distance whose share of points below it is given, in any direction.
template <typename Distance>
rbpa_test::Points round_about(std::size_t count, std::uint64_t seed, Distance distance) {
  rbpa_test::Random random(seed);
  rbpa_test::Points points;
  while (points.size() < count) {
    const double r = distance(random.unit()), angle = 2 * std::numbers::pi * random.unit();
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

rbpa_test::Points gaussian_clusters(std::size_t count) {
  rbpa_test::Random random(4);
  rbpa_test::Points points;
  for (int cluster = 0; cluster < 100; ++cluster) {
    const double x = random.unit(), y = random.unit(), width = 0.05 * std::pow(10, -3 * random.unit());
    for (const rbpa::Point& p : round_about(count / 100, 5 + static_cast<std::uint64_t>(cluster),
                                            [](double u) { return std::sqrt(-2 * std::log(1 - u)); }))
      points.push_back({x + width * p.x, y + width * p.y});
  }
  random.shuffle(points);
  return points;
}

}  // namespace

Run run_hrbpa_with(std::span<const rbpa::Point> points, double alpha, std::size_t leaf_capacity) {
  const auto start = std::chrono::steady_clock::now();
  const rbpa::Hierarchy hierarchy = rbpa::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .progress = {}});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return {seconds.count(), hierarchy.complex.mesh.n_faces()};
}

Run run_hrbpa(std::span<const rbpa::Point> points, double alpha) {
  return run_hrbpa_with(points, alpha, rbpa::HierarchyOptions().leaf_capacity);
}

Run run_rbpa(std::span<const rbpa::Point> points, double alpha) {
  return timed(points, alpha, rbpa::Search::near_to_far);
}

Run run_rbpa_paper_grid(std::span<const rbpa::Point> points, double alpha) {
  return timed(points, alpha, rbpa::Search::paper_grid);
}

const Workload uniform{"uniform", [](std::size_t count) { return rbpa_test::uniform(count, 1); }};
const Workload jittered{"jittered", [](std::size_t count) { return rbpa_test::jittered_grid(columns(count), 0.9, 2); }};
const Workload grid{"grid", [](std::size_t count) { return rbpa_test::perfect_grid(columns(count), 1); }};
const Workload clusters{"clusters", gaussian_clusters};
const Workload kuzmin{"Kuzmin", [](std::size_t count) {
                        // The outermost 10⁻⁶ of the points would lie anywhere.
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

rbpa_test::Points two_level_sampling(std::size_t count) {
  rbpa_test::Random random(9);
  rbpa_test::Points points;
  // Jittered rows in two squares side by side, the pitch of the second twice that of the first.
  const double pitch = std::sqrt(2 / static_cast<double>(count));
  for (const double scale : {1.0, 2.0})
    for (double y = 0; y < scale; y += scale * pitch)
      for (double x = scale - 1; x < 2 * scale - 1; x += scale * pitch)
        points.push_back({x + 0.4 * scale * pitch * random.unit(), y + 0.4 * scale * pitch * random.unit()});
  return points;
}

}  // namespace rbpa_bench
