#include "rbpa/space/balls/full/ball_wedges.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

// The same formulas are evaluated in double and in double-double.
template <typename Real>
Real apart(double a, double b) {
  if constexpr (std::is_same_v<Real, double>)
    return a - b;
  else
    return Real::difference(a, b);
}
template <typename Real>
Real exactly(double value) {
  return apart<Real>(value, 0);
}
double rounded(double value) { return value; }
double rounded(const DoubleDouble& value) { return value.high; }

template <typename Real>
Vector3<Real> edge_to(const Ball& a, const Ball& b) {
  const Point3 &p = a.center, &q = b.center;
  return {apart<Real>(q.x, p.x), apart<Real>(q.y, p.y), apart<Real>(q.z, p.z)};
}
template <typename Real>
Vector3<Real> times(const Real& s, const Vector3<Real>& v) {
  return {s * v.x, s * v.y, s * v.z};
}

/// The edge from a ball to another one, times a power of two that keeps the square of a short edge within the range of
/// double. The points x, relative to the first center, of the same power to both have x · to = lift.
template <typename Real>
struct BallEdge {
  BallEdge(const Ball& a, const Ball& b) : to(edge_to<Real>(a, b)), square(dot(to, to)) {
    if (rounded(square) < 0x1p-400) {
      const double greatest = std::max({std::abs(rounded(to.x)), std::abs(rounded(to.y)), std::abs(rounded(to.z))});
      scale = std::ldexp(1, std::min(-std::ilogb(greatest), 900));
      to = times(exactly<Real>(scale), to);
      square = dot(to, to);
    }
    shrink = exactly<Real>(scale) * apart<Real>(a.radius, b.radius);
    lift = exactly<Real>(0.5) * (exactly<Real>(1 / scale) * square + shrink * apart<Real>(a.radius, -b.radius));
  }
  double scale = 1;
  Vector3<Real> to;
  Real square, lift, shrink;  // shrink: difference of the radii
};

/// Ratio of squares below which a rounded difference has lost too many digits.
constexpr double lossy = 0x1p-10;

/// Ball k seen along the edge from i to j: perpendicular to the edge it is at `away`, at the distance y. The line of
/// same power to all three is `offset` / y from the edge, and moves by `rate` / y when all radii grow. Both ends of the
/// edge give the same; in double-double it is the nearer one, from which short distances are exact.
template <typename Real>
struct BallBeside {
  BallBeside(const BallEdge<Real>& edge, const Ball& i, const Ball& j, const Ball& k) {
    if (!std::is_same_v<Real, double> && distance(j.center, k.center) < distance(i.center, k.center))
      set(BallEdge<Real>(j, i), BallEdge<Real>(j, k));
    else
      set(edge, BallEdge<Real>(i, k));
  }
  Vector3<Real> away;
  Real square, offset, rate;  // square: y²
  bool is_thin;

 private:
  void set(const BallEdge<Real>& edge, const BallEdge<Real>& spoke) {
    const Real along = dot(spoke.to, edge.to) / edge.square;
    away = minus(spoke.to, times(along, edge.to));
    square = dot(away, away);
    offset = spoke.lift - along * edge.lift;
    rate = spoke.shrink - along * edge.shrink;
    is_thin = rounded(square) < lossy * rounded(spoke.square);
  }
};

/// A result, and whether it needs double-double.
template <typename Result>
struct Tried {
  Result result;
  bool is_rough;
};

template <typename Real>
Tried<WedgePart> in_tetrahedron(const Ball& i, const Ball& j, const Ball& k, const Ball& l, bool with_angle) {
  const BallEdge<Real> edge(i, j);
  const BallBeside<Real> a(edge, i, j, k), b(edge, i, j, l);
  const Real cosine = dot(a.away, b.away);  // times both distances, as is the sine
  const double sine = std::abs(rounded(dot(edge.to, cross(a.away, b.away)))) / std::sqrt(rounded(edge.square));
  if (!(sine > 0)) return {{}, true};
  const Real oo = a.offset * b.offset, aa = a.offset * a.offset / a.square, bb = b.offset * b.offset / b.square;
  WedgePart part;
  part.area = rounded(oo + oo - (aa + bb) * cosine) / (2 * sine);
  part.growth = rounded(a.rate * b.offset + a.offset * b.rate -
                        (a.rate * a.offset / a.square + b.rate * b.offset / b.square) * cosine) /
                sine;
  if (with_angle) part.angle = std::atan2(sine, rounded(cosine));
  const double terms = 2 * std::abs(rounded(oo)) + rounded(aa + bb) * std::abs(rounded(cosine));
  return {part, a.is_thin || b.is_thin || lossy * terms > sine * i.radius * i.radius};
}

template <typename Real>
Tried<WedgePart> beside_triangle(const Ball& i, const Ball& j, const Ball& k) {
  const BallEdge<Real> edge(i, j);
  const BallBeside<Real> side(edge, i, j, k);
  const Real radius = exactly<Real>(i.radius), ii = radius * radius;
  // Half of the chord in which the line of same power meets the balls, squared.
  const double square = rounded(ii - edge.lift * edge.lift / edge.square - side.offset * side.offset / side.square);
  const double half = std::sqrt(std::max(square, 0.0)), y = std::sqrt(rounded(side.square));
  if (!(y > 0)) return {{}, true};
  const double away = rounded(side.offset) / y;
  return {{std::atan2(half, away), half * away / 2, half * rounded(side.rate) / y},
          side.is_thin || square < lossy * rounded(ii)};
}

template <typename Real>
Tried<double> corner_angle(const Ball& i, const Ball& j, const Ball& k) {
  const BallEdge<Real> u(i, j), v(i, k);
  const Vector3<Real> normal = cross(u.to, v.to), w = minus(times(u.lift, v.to), times(v.lift, u.to));
  const Real nn = dot(normal, normal), radius = exactly<Real>(i.radius), ii = radius * radius;
  const double square = rounded(nn) > 0 ? std::min(rounded(ii - dot(w, w) / nn), rounded(ii)) : 0;
  const double y = i.radius * std::sqrt(std::max(square, 0.0) * rounded(nn)),
               x = rounded(ii * dot(u.to, v.to) - u.lift * v.lift);
  return {std::atan2(y, x),
          rounded(nn) < lossy * rounded(u.square) * rounded(v.square) || square < lossy * rounded(ii)};
}

}  // namespace

BallCircle::BallCircle(const Ball& i, const Ball& j) : i_(i), j_(j) {
  const Vector3<double> to = edge_to<double>(i, j);
  const double to_square = dot(to, to);
  distance = to_square > 0x1p-400 ? std::sqrt(to_square) : std::hypot(to.x, to.y, to.z);
  const double shift = (i.radius - j.radius) / distance * (i.radius + j.radius) / 2;
  height_i = distance / 2 + shift;
  height_j = distance / 2 - shift;
  square = std::max((i.radius - height_i) * (i.radius + height_i), 0.0);
}

WedgePart BallCircle::in_tetrahedron(const Ball& k, const Ball& l, bool with_angle) const {
  const Tried<WedgePart> tried = space::in_tetrahedron<double>(i_, j_, k, l, with_angle);
  if (!tried.is_rough) return tried.result;
  return space::in_tetrahedron<DoubleDouble>(i_, j_, k, l, with_angle).result;
}

WedgePart BallCircle::beside_triangle(const Ball& k) const {
  const Tried<WedgePart> tried = space::beside_triangle<double>(i_, j_, k);
  return tried.is_rough ? space::beside_triangle<DoubleDouble>(i_, j_, k).result : tried.result;
}

double corner_angle(const Ball& i, const Ball& j, const Ball& k) {
  const Tried<double> tried = corner_angle<double>(i, j, k);
  return tried.is_rough ? corner_angle<DoubleDouble>(i, j, k).result : tried.result;
}

}  // namespace rbpa::space
