#include "support/exact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/rational.h"

namespace rbpa_test::exact {
namespace {

struct Vector {
  Rational x, y;
};

Vector from(const Point& a, const Point& b) { return {rational(b.x) - rational(a.x), rational(b.y) - rational(a.y)}; }
Rational dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }
Rational cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }

using Corners = std::array<Point, 4>;

/// Returns the factor of row i's lift in the determinant of the rows (x, y, lift, 1), up to one common sign.
Rational cofactor(const Corners& rows, unsigned i) {
  std::array<Point, 3> others;
  for (unsigned j = 0, k = 0; j < 4; ++j)
    if (j != i) others[k++] = rows[j];
  const Rational area = cross(from(others[0], others[1]), from(others[0], others[2]));
  return i % 2 == 0 ? area : Rational(-area);
}

Rational lift(const Point& origin, const Point& p) {
  const Vector v = from(origin, p);
  return dot(v, v);
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) { return cross(from(a, b), from(a, c)).sign(); }

int in_circle(const Point& a, const Point& b, const Point& p, const Point& q) {
  const Corners rows = {a, b, p, q};
  Rational determinant = 0;
  for (unsigned i = 0; i < 4; ++i) determinant += lift(a, rows[i]) * cofactor(rows, i);
  return determinant.sign();
}

int in_perturbed_circle(const Point& a, const Point& b, const Point& p, const Point& q) {
  if (const int side = in_circle(a, b, p, q); side != 0) return side;
  const Corners rows = {a, b, p, q};
  std::array<unsigned, 4> order = {0, 1, 2, 3};
  std::sort(order.begin(), order.end(), [&](unsigned i, unsigned j) { return rows[j] < rows[i]; });
  for (const unsigned i : order)
    if (const int side = cofactor(rows, i).sign(); side != 0) return side;
  return 0;
}

int compare_circumradius(const Point& a, const Point& b, const Point& c, double alpha) {
  const Vector u = from(a, b), v = from(a, c);
  const Rational uu = dot(u, u), vv = dot(v, v), twice_cross = 2 * cross(u, v);
  const Vector center{(uu * v.y - vv * u.y) / twice_cross, (vv * u.x - uu * v.x) / twice_cross};
  const Rational radius = rational(alpha), difference = dot(center, center) - radius * radius;
  return difference.sign();
}

int compare_to_diameter(const Point& a, const Point& b, double alpha) {
  const Rational diameter = 2 * rational(alpha), difference = lift(a, b) - diameter * diameter;
  return difference.sign();
}

int compare_distances(const Point& v, const Point& p, const Point& q) {
  const Rational difference = lift(v, p) - lift(v, q);
  return difference.sign();
}

int dot_sign(const Point& v, const Point& p, const Point& q) { return dot(from(v, p), from(v, q)).sign(); }

bool in_disc(const Point& center, double radius, const Point& p) {
  const Rational r = rational(radius);
  return lift(center, p) <= r * r;
}

}  // namespace rbpa_test::exact
