#include "rbpa/space/surface/neighbors/distinct_points.h"

#include <algorithm>
#include <cmath>

#include "rbpa/space/cells/scale.h"

namespace rbpa::space {

DistinctPoints distinct_points(std::span<const Point3> points) {
  struct Numbered {
    Point3 at;
    std::uint32_t index;
  };
  std::vector<Numbered> sorted;
  sorted.reserve(points.size());
  for (const Point3& p : points) sorted.push_back({p, static_cast<std::uint32_t>(sorted.size())});
  std::sort(sorted.begin(), sorted.end(), [](const Numbered& p, const Numbered& q) { return p.at < q.at; });
  DistinctPoints found;
  found.number.resize(points.size());
  for (const Numbered& p : sorted) {
    if (found.points.empty() || found.points.back() != p.at) found.points.push_back(p.at);
    found.number[p.index] = static_cast<std::uint32_t>(found.points.size() - 1);
  }
  return found;
}

std::optional<int> fit_double(std::vector<Point3>& points) {
  double greatest = 0;
  for (const Point3& p : points) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (greatest == 0) return 0;
  const std::optional<int> exponent = scale_to_double(points, greatest);
  if (exponent && *exponent != 0)
    for (Point3& p : points) p = {std::ldexp(p.x, *exponent), std::ldexp(p.y, *exponent), std::ldexp(p.z, *exponent)};
  return exponent;
}

}  // namespace rbpa::space
