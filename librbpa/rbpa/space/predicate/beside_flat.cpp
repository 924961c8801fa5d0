#include "rbpa/space/predicate/beside_flat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {

std::vector<Point3> beside_flat(std::span<const Point3> points) {
  constexpr std::array<double Point3::*, 3> axes = {&Point3::x, &Point3::y, &Point3::z};
  const Point3& a = points[0];
  double size = 0;
  for (const Point3& p : points)
    for (const auto axis : axes) size = std::max(size, std::abs(p.*axis));
  std::array<Point3, 3> along = {a, a, a};  // the first point, moved along each axis
  for (std::size_t k = 0; k < 3; ++k) along[k].*axes[k] = a.*axes[k] != 0 ? 0 : size > 0 ? size : 1;

  const auto other = std::find_if(points.begin(), points.end(), [&](const Point3& p) { return p != a; });
  if (other == points.end()) return {along.begin(), along.end()};
  const Point3& b = *other;
  const auto third = std::find_if(other, points.end(), [&](const Point3& c) { return !are_collinear(a, b, c); });
  if (third == points.end()) {
    std::size_t differs = 0;
    while (a.*axes[differs] == b.*axes[differs]) ++differs;
    return {along[(differs + 1) % 3], along[(differs + 2) % 3]};
  }
  return {
      *std::find_if(along.begin(), along.end(), [&](const Point3& p) { return orientation(a, b, *third, p) != 0; })};
}

}  // namespace rbpa::space
