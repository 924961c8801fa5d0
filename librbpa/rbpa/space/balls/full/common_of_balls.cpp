#include "rbpa/space/balls/full/common_of_balls.h"

#include <algorithm>

namespace rbpa::space {
namespace {

using std::numbers::pi;

Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

}  // namespace

Vector unit(const Vector& v) {
  const double size = norm(v);
  return size > 0 ? 1 / size * v : v;
}

double solid_angle(const Vector& a, const Vector& b, const Vector& c) {
  return 2 * std::atan2(std::abs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(a, c) + dot(b, c)) / (4 * pi);
}

double dihedral_angle(const Vector& edge, const Vector& a, const Vector& b) {
  const Vector to_a = unit(cross(edge, a)), to_b = unit(cross(edge, b));
  return std::atan2(norm(cross(to_a, to_b)), dot(to_a, to_b)) / (2 * pi);
}

Measure two_balls(double distance) {
  const double height = std::max(2 - distance, 0.0);  // sum of the heights of both caps
  return {pi / 12 * (4 + distance) * height * height, 2 * pi * height};
}

// The three spheres meet in two points. The tetrahedron of the centers and one of these points has shares of one ball
// each, less shares of two balls, plus half of the intersection of three.
Measure three_balls(const Vector& u, const Vector& v) {
  const double lu = norm(u), lv = norm(v);
  const Vector eu = unit(u), ev = unit(v), n = cross(eu, ev), ew = unit(v - u);
  const double nn = dot(n, n);
  if (!(nn > 0)) return two_balls(std::max(lu, lv));  // two of the three balls have the same center
  const Vector center = 1 / (2 * nn) * (lu * cross(ev, n) + lv * cross(n, eu));
  const double height = std::sqrt(std::max(1 - dot(center, center), 0.0));
  const Vector apex = center + height / std::sqrt(nn) * n;
  const Vector from_o = unit(apex), from_u = unit(apex - u), from_v = unit(apex - v);
  const double balls =
      solid_angle(eu, ev, from_o) + solid_angle(-1 * eu, ew, from_u) + solid_angle(-1 * ev, -1 * ew, from_v);
  Measure common = {lu * lv * std::sqrt(nn) * height / 6 - balls * one_ball.volume, -balls * one_ball.area};
  const auto add = [&](double distance, double angle) {
    const Measure two = two_balls(distance);
    common.volume += angle * two.volume;
    common.area += angle * two.area;
  };
  add(lu, dihedral_angle(eu, ev, from_o));
  add(lv, dihedral_angle(ev, eu, from_o));
  add(norm(v - u), dihedral_angle(ew, -1 * eu, from_u));
  return {std::max(2 * common.volume, 0.0), std::max(2 * common.area, 0.0)};
}

}  // namespace rbpa::space
