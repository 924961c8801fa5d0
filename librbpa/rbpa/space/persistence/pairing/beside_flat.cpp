#include "rbpa/space/persistence/pairing/beside_flat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {
namespace {

constexpr std::array<double Point3::*, 3> axes = {&Point3::x, &Point3::y, &Point3::z};

}  // namespace

std::vector<Point3> beside_flat(std::span<const Point3> points) {
  const auto other = std::find_if(points.begin(), points.end(), [&](const Point3& p) { return p != points[0]; });
  if (other == points.end()) return {};
  const Point3 &a = points[0], &b = *other;
  double size = 0;
  for (const Point3& p : points)
    for (const auto axis : axes) size = std::max(size, std::abs(p.*axis));
  // Shift the first point along each axis by the greatest absolute coordinate; toward zero, so that no sum overflows.
  std::array<Point3, 3> along = {a, a, a};
  for (std::size_t k = 0; k < 3; ++k) along[k].*axes[k] += a.*axes[k] > 0 ? -size : size;

  const auto third = std::find_if(other, points.end(), [&](const Point3& c) { return !are_collinear(a, b, c); });
  if (third == points.end()) {
    const auto differs = static_cast<std::size_t>(
        std::find_if(axes.begin(), axes.end(), [&](const auto axis) { return a.*axis != b.*axis; }) - axes.begin());
    return {along[(differs + 1) % 3], along[(differs + 2) % 3]};
  }
  if (std::any_of(third, points.end(), [&](const Point3& d) { return orientation(a, b, *third, d) != 0; })) return {};
  return {
      *std::find_if(along.begin(), along.end(), [&](const Point3& p) { return orientation(a, b, *third, p) != 0; })};
}

}  // namespace rbpa::space
