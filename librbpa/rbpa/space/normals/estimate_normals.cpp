#include "rbpa/space/normals/estimate_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/normals/sides/orient_normals.h"
#include "rbpa/space/normals/sides/outer_sides.h"
#include "rbpa/space/normals/sides/side_confidence.h"
#include "rbpa/space/surface/neighbors/distinct_points.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"
#include "rbpa/space/surface/neighbors/fit_plane.h"

namespace rbpa {
namespace {

using Wide = long double;  // in long double, products of extreme coordinates do not overflow

const Point3& viewpoint_of(std::size_t i, std::span<const Point3> viewpoints) {
  return viewpoints[viewpoints.size() == 1 ? 0 : i];
}

/// Returns the height of the viewpoint `from` above the plane through p with the unit normal n.
Wide height(const Point3& p, const Point3& from, const Point3& n) {
  return (Wide(from.x) - p.x) * n.x + (Wide(from.y) - p.y) * n.y + (Wide(from.z) - p.z) * n.z;
}

/// Returns the confidence that a normal turned toward a viewpoint is on the right side. A plane that is seen at a
/// grazing angle may be seen from either side.
double view_confidence(const Point3& p, const Point3& from, const Point3& n) {
  constexpr double beyond_doubt = 0.25;  // cosine of the angle between normal and view: 76 degrees
  const Wide x = Wide(from.x) - p.x, y = Wide(from.y) - p.y, z = Wide(from.z) - p.z;
  const Wide distance = std::sqrt(x * x + y * y + z * z);
  if (!(distance > 0)) return 0;
  return std::min(1.0, static_cast<double>(std::abs(height(p, from, n)) / distance) / beyond_doubt);
}

void check_viewpoints(std::span<const Point3> points, std::span<const Point3> viewpoints) {
  if (viewpoints.size() != 1 && viewpoints.size() != points.size())
    throw InvalidInput(std::to_string(viewpoints.size()) + " viewpoints for " + std::to_string(points.size()) +
                       " points, expected one, or one for each point");
  for (std::size_t i = 0; i < viewpoints.size(); ++i)
    if (!is_finite(viewpoints[i]))
      throw InvalidInput("viewpoint " + std::to_string(i) + " is not finite, expected finite coordinates");
}

/// Returns the normals of distinct points, in their order, and with `with_confidence` the confidence; not yet turned to
/// viewpoints.
template <typename Real>
EstimatedNormals normals_of(std::vector<Point3> points, const NormalOptions& options, bool with_confidence) {
  const std::size_t count = points.size();
  const GoOn going = go_on_of(options.progress, count);
  const Checkpoint go_on = checkpoint_of(going);
  Threads threads(count < 1000 ? 1 : options.threads);  // for few points, another thread would start too late
  auto [near, normals, confidence] = space::fit_planes<Real>(std::move(points), options.neighbors, threads, go_on);
  if (options.viewpoints.empty()) {
    space::OuterSides sides;
    if constexpr (std::is_same_v<Real, double>)  // points that require long double do not fit the circumcenters
      sides = space::outer_sides(near, normals, {.threads = options.threads, .progress = on_progress_of(going)});
    const space::OrientationTree tree = space::orient_normals<Real>(near, normals, go_on, sides.side);
    if (with_confidence) {
      const std::vector<double> of_side = space::side_confidence<Real>(near, normals, tree, sides, go_on);
      for (std::size_t i = 0; i < count; ++i) confidence[i] = std::min(confidence[i], of_side[i]);
    }
  }
  EstimatedNormals by_number{.normals = std::vector<Point3>(count), .confidence = {}};
  for (std::size_t i = 0; i < count; ++i) by_number.normals[i] = normals[near.place[i]];
  for (std::size_t i = 0; i < count && with_confidence; ++i) by_number.confidence.push_back(confidence[near.place[i]]);
  return by_number;
}

EstimatedNormals estimate(std::span<const Point3> points, const NormalOptions& options, bool with_confidence) {
  space::check_points(points);
  if (options.neighbors < 2)
    throw InvalidInput("normals from " + std::to_string(options.neighbors) + " neighbors, expected at least 2");
  if (!options.viewpoints.empty()) check_viewpoints(points, options.viewpoints);
  if (points.empty()) return {};
  space::DistinctPoints sites = space::distinct_points(points);
  const bool fits = space::fit_double(sites.points).has_value();
  const EstimatedNormals of_sites = fits ? normals_of<double>(std::move(sites.points), options, with_confidence)
                                         : normals_of<long double>(std::move(sites.points), options, with_confidence);
  EstimatedNormals result;
  result.normals.reserve(points.size());
  for (const std::uint32_t number : sites.number) result.normals.push_back(of_sites.normals[number]);
  for (std::size_t i = 0; i < points.size() && with_confidence; ++i)
    result.confidence.push_back(of_sites.confidence[sites.number[i]]);
  if (!options.viewpoints.empty()) {
    turn_toward(points, options.viewpoints, result.normals);
    for (std::size_t i = 0; i < result.confidence.size(); ++i)
      result.confidence[i] = std::min(
          result.confidence[i], view_confidence(points[i], viewpoint_of(i, options.viewpoints), result.normals[i]));
  }
  return result;
}

}  // namespace

void turn_toward(std::span<const Point3> points, std::span<const Point3> viewpoints, std::span<Point3> normals) {
  if (normals.size() != points.size())
    throw InvalidInput(std::to_string(normals.size()) + " normals for " + std::to_string(points.size()) +
                       " points, expected one for each");
  check_viewpoints(points, viewpoints);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point3& n = normals[i];
    const Wide toward = height(points[i], viewpoint_of(i, viewpoints), n);
    const double first = n.z != 0 ? n.z : n.y != 0 ? n.y : n.x;
    if (toward < 0 || (toward == 0 && first < 0)) n = {0.0 - n.x, 0.0 - n.y, 0.0 - n.z};
  }
}

std::vector<Point3> estimate_normals(std::span<const Point3> points, const NormalOptions& options) {
  return estimate(points, options, false).normals;
}

EstimatedNormals estimate_normals_and_confidence(std::span<const Point3> points, const NormalOptions& options) {
  return estimate(points, options, true);
}

}  // namespace rbpa
