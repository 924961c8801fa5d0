// What: angles and areas around the common circle of two balls, within one tetrahedron of the dual complex, or beside a
//       triangle of it that has no tetrahedron on that side.
// How:  docs/explanation/space.md, section 24. Where terms cancel, they are computed again in double-double.
// Law:  errors are some 2^−43 of a full turn, or of the square of a radius.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

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
inline double rounded(double value) { return value; }
inline double rounded(const DoubleDouble& value) { return value.high; }

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
  BallBeside(const BallEdge<Real>& edge, const Ball& i, const Ball& j, const Ball& k) : ball(&k) {
    if (!std::is_same_v<Real, double> && distance(j.center, k.center) < distance(i.center, k.center))
      set(BallEdge<Real>(j, i), BallEdge<Real>(j, k));
    else
      set(edge, BallEdge<Real>(i, k));
  }
  Vector3<Real> away;
  Real square, offset, rate, ratio;  // square: y²; ratio: offset / square
  bool is_thin;
  const Ball* ball;

 private:
  void set(const BallEdge<Real>& edge, const BallEdge<Real>& spoke) {
    const Real along = dot(spoke.to, edge.to) / edge.square;
    away = minus(spoke.to, times(along, edge.to));
    square = dot(away, away);
    offset = spoke.lift - along * edge.lift;
    rate = spoke.shrink - along * edge.shrink;
    ratio = offset / square;
    is_thin = rounded(square) < lossy * rounded(spoke.square);
  }
};

/// The part of the contact of two balls that is in a wedge.
struct WedgePart {
  double angle = 0;   ///< of the wedge; 0 if not requested
  double area = 0;    ///< of the contact's part, less its sector of the disc within the circle where that is exposed
  double growth = 0;  ///< derivative of the area when all radii grow alike, less the same
};

/// The circle in which the spheres of balls i and j meet. Keeps references.
class BallCircle {
 public:
  BallCircle(const Ball& i, const Ball& j);

  double distance;            ///< of the centers
  double height_i, height_j;  ///< signed distances of the circle's plane from the centers, toward the other center
  double square;              ///< of the radius

  /// A third ball as seen along the edge. Keeps a reference to it.
  using Side = BallBeside<double>;
  Side side(const Ball& k) const { return {edge_, i_, j_, k}; }
  /// Returns the part in the tetrahedron of balls i, j, k, l.
  WedgePart in_tetrahedron(const Side& k, const Side& l, bool with_angle) const;
  /// Returns the part between the triangle of balls i, j, k and the point beside it in which their spheres meet.
  WedgePart beside_triangle(const Side& k) const;

 private:
  const Ball &i_, &j_;
  BallEdge<double> edge_;
};

/// Returns the angle at the sphere of ball i, in the point where it meets those of j and k, between the directions
/// toward j and k: of the spherical triangle of these directions and that point.
double corner_angle(const Ball& i, const Ball& j, const Ball& k);

}  // namespace rbpa::space
