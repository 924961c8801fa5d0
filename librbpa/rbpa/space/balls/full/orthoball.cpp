#include "rbpa/space/balls/full/orthoball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

using Real = DoubleDouble;
using WideVector = Vector3<Real>;

}  // namespace

// Let u be the vector from the first center to that of another ball, with the radii R and S. Points x of equal power to
// both balls have x · u = (u² + R² − S²) / 2; for points at an equal distance s from both balls, x · u is greater by s
// (R − S). So points at an equal distance from all are x = center + s · slope, and |x| = R + s is a quadratic equation.
Orthoball orthoball(std::span<const Ball> balls) {
  std::vector<Ball> b(balls.begin(), balls.end());
  std::sort(b.begin(), b.end(), [](const Ball& p, const Ball& q) { return p.center < q.center; });
  const Point3& origin = b[0].center;
  const Real half{0.5, 0}, radius{b[0].radius, 0};
  std::array<WideVector, 3> to{}, dual{};
  for (std::size_t k = 0; k + 1 < balls.size(); ++k) {
    const Point3& p = b[k + 1].center;
    to[k] = {Real::difference(p.x, origin.x), Real::difference(p.y, origin.y), Real::difference(p.z, origin.z)};
  }
  if (balls.size() == 3) to[2] = cross(to[0], to[1]);
  for (std::size_t k = 0; k < 3; ++k) dual[k] = cross(to[(k + 1) % 3], to[(k + 2) % 3]);
  const Real volume = dot(dual[0], to[0]);
  WideVector center{}, slope{};
  for (std::size_t k = 0; k + 1 < balls.size(); ++k) {
    const Real less = Real::difference(b[0].radius, b[k + 1].radius);
    const Real lift = half * (dot(to[k], to[k]) + less * Real::difference(b[0].radius, -b[k + 1].radius));
    center = plus(center, times(lift / volume, dual[k]));
    slope = plus(slope, times(less / volume, dual[k]));
  }
  const double power = (dot(center, center) - radius * radius).high;
  const double linear = (radius - dot(center, slope)).high, square = (Real{1, 0} - dot(slope, slope)).high;
  const double s = power / (linear + std::sqrt(linear * linear + square * power));
  const auto at = [&](double t) {
    return Point3{origin.x + (center.x.high + t * slope.x.high), origin.y + (center.y.high + t * slope.y.high),
                  origin.z + (center.z.high + t * slope.z.high)};
  };
  return {at(0), power, {at(s), s}};
}

}  // namespace rbpa::space
