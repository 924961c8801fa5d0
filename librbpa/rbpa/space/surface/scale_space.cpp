#include "rbpa/space/surface/scale_space.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/surface/neighbors/distinct_points.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"
#include "rbpa/space/surface/neighbors/fit_plane.h"

namespace rbpa {
namespace {

/// Moves the points by one step. Returns the noise: the median distance, in spacings, between a point's move and the
/// mean move of its neighbors; 0 for a single point. Curvature moves neighbors together, so it is not noise.
template <typename Real>
double step(std::vector<Point3>& points, const ScaleSpaceOptions& options, const Checkpoint& go_on) {
  space::DistinctPoints sites = space::distinct_points(points);
  Threads threads(sites.points.size() < 1000 ? 1 : options.threads);
  const auto [near, normals, flatness] =
      space::fit_planes<Real>(std::move(sites.points), options.neighbors, threads, go_on);
  if (near.count == 0) return 0;
  std::vector<Point3> ways(near.points.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Point3 &p = near.points[i], &n = normals[i];
    Real above = 0;  // sum of the heights of the others above the point
    for (const std::uint32_t j : near.around(i)) {
      const Point3& q = near.points[j];
      above += (Real(q.x) - p.x) * n.x + (Real(q.y) - p.y) * n.y + (Real(q.z) - p.z) * n.z;
    }
    const auto by = static_cast<double>(above / static_cast<Real>(near.count + 1));
    ways[i] = {by * n.x, by * n.y, by * n.z};
  }
  std::vector<double> noise(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    Point3 sum = {0, 0, 0};
    for (const std::uint32_t j : near.around(i)) sum = {sum.x + ways[j].x, sum.y + ways[j].y, sum.z + ways[j].z};
    const auto count = static_cast<double>(near.count);
    noise[i] = std::hypot(ways[i].x - sum.x / count, ways[i].y - sum.y / count, ways[i].z - sum.z / count);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t at = near.place[sites.number[i]];
    const Point3 &p = near.points[at], &way = ways[at];
    points[i] = {p.x + way.x, p.y + way.y, p.z + way.z};
  }
  const auto median = noise.begin() + static_cast<std::ptrdiff_t>(noise.size() / 2);
  std::nth_element(noise.begin(), median, noise.end());
  return *median / space::spacing_of(near);
}

}  // namespace

ScaleSpace scale_space(std::span<const Point3> points, const ScaleSpaceOptions& options) {
  space::check_points(points);
  if (options.neighbors < 2)
    throw InvalidInput("scale space from " + std::to_string(options.neighbors) + " neighbors, expected at least 2");
  ScaleSpace result{.points = {points.begin(), points.end()}, .steps = 0};
  if (points.empty()) return result;
  const Checkpoint go_on = checkpoint_of(options.progress, points.size());
  const std::optional<int> exponent = space::fit_double(result.points);
  constexpr std::size_t most = 8;
  constexpr double little = 0.1;  // noise, in spacings, below which the steps end
  while (result.steps < (options.steps == 0 ? most : options.steps)) {
    const double noise =
        exponent ? step<double>(result.points, options, go_on) : step<long double>(result.points, options, go_on);
    ++result.steps;
    if (options.steps == 0 && noise < little) break;
  }
  if (exponent && *exponent != 0)
    for (Point3& p : result.points)
      p = {std::ldexp(p.x, -*exponent), std::ldexp(p.y, -*exponent), std::ldexp(p.z, -*exponent)};
  return result;
}

}  // namespace rbpa
