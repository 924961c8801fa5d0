// What: computes angles and areas around the common circle of two balls, within one tetrahedron of the dual complex, or
//       beside a triangle of the complex on a side without a tetrahedron of the complex.
// How:  docs/explanation/space.md, section 24. Computes in double, from the scalar products of edges at one ball; if
//       terms cancel, computes again in double-double, from vectors.
// Law:  errors are about 2^−43 of a full turn for angles, and of the square of a radius for areas.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

// The formulas are evaluated in double and in double-double: `Real` is one of the two.
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

/// The vector from the center of a ball to that of another one, multiplied by a power of two that keeps the square of a
/// short edge within the range of double. The points x, relative to the first center, that have the same power to both
/// balls satisfy x · to = lift. Refers to the balls.
template <typename Real>
struct BallEdge {
  BallEdge(const Ball& first, const Ball& second)
      : a(&first), b(&second), to(edge_to<Real>(*a, *b)), square(dot(to, to)) {
    if (rounded(square) < 0x1p-400) {
      const double greatest = std::max({std::abs(rounded(to.x)), std::abs(rounded(to.y)), std::abs(rounded(to.z))});
      scale = std::ldexp(1, std::min(-std::ilogb(greatest), 900));
      to = times(exactly<Real>(scale), to);
      square = dot(to, to);
    }
    shrink = exactly<Real>(scale) * apart<Real>(a->radius, b->radius);
    lift = exactly<Real>(0.5) * (exactly<Real>(1 / scale) * square + shrink * apart<Real>(a->radius, -b->radius));
  }
  const Ball *a, *b;
  double scale = 1;
  Vector3<Real> to;
  Real square, lift, shrink;  // shrink: difference of the radii, times the power of two
};

/// The edge in double, with derived numbers.
struct EdgeOfBalls : BallEdge<double> {
  EdgeOfBalls(const Ball& first, const Ball& second)
      : BallEdge(first, second), inverse_length(1 / std::sqrt(square)), inverse(inverse_length * inverse_length) {
    const double r = first.radius, s = second.radius;
    is_uneven = std::min(r, s) < 0x1p-10 * std::max(r, s);
    is_tangent = std::abs(r * r - lift * lift * inverse) <= 0x1p-40 * (r * r + s * s) && are_tangent();
  }
  double inverse_length, inverse;  // inverse: of the square
  bool is_uneven;                  // one ball is so small that lengths rounded for the other are too rough for it
  /// Whether the spheres touch, up to rounding in double-double: points on their circle then have no direction.
  bool is_tangent;

 private:
  bool are_tangent() const;
};

/// The part of the contact of two balls that is in a wedge.
struct WedgePart {
  double angle = 0;  ///< angle of the wedge; 0 if not requested
  /// Area of the quadrangle of the contact in the wedge (docs/explanation/space.md, section 24), without sectors of the
  /// disc.
  double area = 0;
  double growth = 0;  ///< derivative of `area` when all radii grow alike
};

/// The three edges from one ball to the others of a tetrahedron, and the scalar products of the edges.
struct EdgesAtCorner {
  explicit EdgesAtCorner(const std::array<const EdgeOfBalls*, 3>& edges);
  std::array<const EdgeOfBalls*, 3> edge;
  std::array<double, 3> product;  ///< for each edge, the product of the other two
  double volume;                  ///< six times the volume of the tetrahedron
};

/// Returns the part of the contact at edge k that is in the tetrahedron.
WedgePart in_tetrahedron(const EdgesAtCorner& at, std::size_t k, bool with_angle);
/// Returns the part of the contact (measure_balls.h) of the balls of `edge` in the wedge between the triangle of both
/// edges and the point in which the spheres of the three balls meet.
WedgePart beside_triangle(const EdgeOfBalls& edge, const EdgeOfBalls& other);

/// The circle in which the spheres of two balls meet.
struct CircleOfBalls {
  explicit CircleOfBalls(const EdgeOfBalls& edge);

  double distance;            ///< distance of the centers
  double height_i, height_j;  ///< signed distances of the circle's plane from the centers, toward the other center
  double square;              ///< square of the circle's radius
};

/// A circle that measures wedges around it. Refers to the balls.
struct BallCircle : CircleOfBalls {
  BallCircle(const Ball& i, const Ball& j) : BallCircle(EdgeOfBalls(i, j)) {}
  explicit BallCircle(const EdgeOfBalls& of) : CircleOfBalls(of), edge(of) {}

  /// Return the part in a tetrahedron with two more balls, and the part beside a triangle with a third ball.
  WedgePart in_tetrahedron(const Ball& k, const Ball& l, bool with_angle) const {
    const EdgeOfBalls to_k(*edge.a, k), to_l(*edge.a, l);
    return space::in_tetrahedron(EdgesAtCorner({&edge, &to_k, &to_l}), 0, with_angle);
  }
  WedgePart beside_triangle(const Ball& k) const { return space::beside_triangle(edge, {*edge.a, k}); }

  EdgeOfBalls edge;
};

/// Returns an angle of a spherical triangle on the sphere of the common first ball. Its corners are the directions
/// toward balls j and k, and a point in which the three spheres meet; the angle is at this point.
double corner_angle(const EdgeOfBalls& j, const EdgeOfBalls& k);
inline double corner_angle(const Ball& i, const Ball& j, const Ball& k) { return corner_angle({i, j}, {i, k}); }

}  // namespace rbpa::space
