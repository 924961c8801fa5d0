#include "rbpa/space/surface/spacing/tangent_cell.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rbpa::space {
namespace {

double dot(const Point3& p, const Point3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
Point3 cross(const Point3& p, const Point3& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

struct Corner {
  double x, y;
};

/// Replaces a convex polygon by the part in which ax + by ≤ c. `kept` is working memory.
void clip(std::vector<Corner>& polygon, double a, double b, double c, std::vector<Corner>& kept) {
  kept.clear();
  const auto beyond = [&](const Corner& p) { return a * p.x + b * p.y - c; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = beyond(p), at_q = beyond(q);
    if (at_p <= 0) kept.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      const double t = at_p / (at_p - at_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  polygon.swap(kept);
}

}  // namespace

std::optional<double> gap_around(std::span<const Point3> neighbors, const Point3& n, double reach) {
  if (neighbors.size() < 3) return std::nullopt;
  const Point3 axis = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? Point3{1, 0, 0}
                      : std::abs(n.y) <= std::abs(n.z)                                 ? Point3{0, 1, 0}
                                                                                       : Point3{0, 0, 1};
  Point3 u = cross(n, axis);
  const double size = std::sqrt(dot(u, u));
  u = {u.x / size, u.y / size, u.z / size};
  const Point3 v = cross(n, u);

  const double half = 2 * reach;
  std::vector<Corner> cell = {{-half, -half}, {half, -half}, {half, half}, {-half, half}}, kept;
  for (const Point3& p : neighbors) clip(cell, dot(p, u), dot(p, v), dot(p, p) / 2, kept);
  double square = 0;
  for (const Corner& corner : cell) square = std::max(square, corner.x * corner.x + corner.y * corner.y);
  if (square > reach * reach) return std::nullopt;
  return std::sqrt(square);
}

std::optional<double> nearest_circumradius(std::span<const Point3> neighbors) {
  constexpr double straight = 0x1p-40;  // the sine of an angle that may be due to rounding
  for (std::size_t i = 1; i < neighbors.size(); ++i) {
    const Point3 &p = neighbors.front(), &q = neighbors[i], d = {q.x - p.x, q.y - p.y, q.z - p.z}, n = cross(p, q);
    const double sides = std::sqrt(dot(p, p)) * std::sqrt(dot(q, q)), area = std::sqrt(dot(n, n));
    if (area > straight * sides) return sides * std::sqrt(dot(d, d)) / (2 * area);
  }
  return std::nullopt;
}

}  // namespace rbpa::space
