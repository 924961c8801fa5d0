#include "rbpa/estimate_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/normals/distinct_points.h"
#include "rbpa/space/normals/find_nearest.h"
#include "rbpa/space/normals/fit_plane.h"
#include "rbpa/space/normals/orient_normals.h"
#include "rbpa/space/normals/outer_sides.h"

namespace rbpa {
namespace {

void check_viewpoints(std::span<const Point3> points, std::span<const Point3> viewpoints) {
  if (viewpoints.size() != 1 && viewpoints.size() != points.size())
    throw InvalidInput(std::to_string(viewpoints.size()) + " viewpoints of " + std::to_string(points.size()) +
                       " points, expected one, or one of each");
  for (std::size_t i = 0; i < viewpoints.size(); ++i)
    if (!is_finite(viewpoints[i]))
      throw InvalidInput("viewpoint " + std::to_string(i) + " is not finite, expected finite coordinates");
}

/// The normals of distinct points, in their order.
template <typename Real>
std::vector<Point3> normals_of(std::vector<Point3> points, const NormalOptions& options) {
  const std::size_t count = points.size();
  const std::function<void()> go_on = asking(options.progress, count);
  Threads threads(count < 1000 ? 1 : options.threads);  // a few are done before another thread has woken
  auto [near, normals] = space::fit_planes<Real>(std::move(points), options.neighbors, threads, go_on);
  if (options.viewpoints.empty()) {
    space::orient_normals<Real>(near, normals, go_on);
    if constexpr (std::is_same_v<Real, double>) {  // others do not fit the sums of areas either
      const auto watch = [&options, count](const Progress&) {
        return !options.progress || options.progress({0, count});
      };
      const std::vector<std::int8_t> sides =
          space::outer_sides(near, normals, {.threads = options.threads, .progress = watch});
      if (!sides.empty()) space::orient_normals<Real>(near, normals, go_on, sides);
    }
  }
  std::vector<Point3> by_number(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) by_number[i] = normals[near.place[i]];
  return by_number;
}

}  // namespace

void turn_toward(std::span<const Point3> points, std::span<const Point3> viewpoints, std::span<Point3> normals) {
  if (normals.size() != points.size())
    throw InvalidInput(std::to_string(normals.size()) + " normals of " + std::to_string(points.size()) +
                       " points, expected one of each");
  check_viewpoints(points, viewpoints);
  using Real = long double;  // products of extreme coordinates do not overflow
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3 &p = points[i], &from = viewpoints[viewpoints.size() == 1 ? 0 : i];
    Point3& n = normals[i];
    const Real toward = (Real(from.x) - p.x) * n.x + (Real(from.y) - p.y) * n.y + (Real(from.z) - p.z) * n.z;
    const double first = n.z != 0 ? n.z : n.y != 0 ? n.y : n.x;
    if (toward < 0 || (toward == 0 && first < 0)) n = {0.0 - n.x, 0.0 - n.y, 0.0 - n.z};
  }
}

std::vector<Point3> estimate_normals(std::span<const Point3> points, const NormalOptions& options) {
  space::check_points(points);
  if (options.neighbors < 2)
    throw InvalidInput("normals from " + std::to_string(options.neighbors) + " neighbors, expected at least 2");
  if (!options.viewpoints.empty()) check_viewpoints(points, options.viewpoints);
  if (points.empty()) return {};
  space::DistinctPoints sites = space::distinct_points(points);
  const bool fits = space::fit_double(sites.points).has_value();
  const std::vector<Point3> normals = fits ? normals_of<double>(std::move(sites.points), options)
                                           : normals_of<long double>(std::move(sites.points), options);
  std::vector<Point3> result;
  result.reserve(points.size());
  for (const std::uint32_t number : sites.number) result.push_back(normals[number]);
  if (!options.viewpoints.empty()) turn_toward(points, options.viewpoints, result);
  return result;
}

}  // namespace rbpa
