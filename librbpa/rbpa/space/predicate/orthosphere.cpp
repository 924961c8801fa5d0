#include "rbpa/space/predicate/orthosphere.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <type_traits>

#include "rbpa/base/exact/integer_scale.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

constexpr double roundoff = 0x1p-53;

/// The edge from a first ball to another one. The plane in which both have the same power is 2 x · to = lift, for x
/// relative to the first center.
template <typename Real>
struct Edge {
  Vector3<Real> to;
  Real square, lift;
};

struct RoundedEdge : Edge<double> {
  RoundedEdge(const Ball& a, const Ball& b) {
    to = from<double>(a.center, b.center);
    square = dot(to, to);
    const double weights = (a.radius - b.radius) * (a.radius + b.radius);
    lift = square + weights;
    length = std::sqrt(square);
    size = square + std::abs(weights);
  }
  double length, size;  // size: of all terms of the lift
};

/// Converts balls to integers.
class Exact {
 public:
  Exact(std::initializer_list<const Ball*> balls) : first_(**balls.begin()) {
    for (const Ball* ball : balls)
      for (const double value : {ball->center.x, ball->center.y, ball->center.z, ball->radius}) scale_.include(value);
  }
  Edge<Integer> edge(const Ball& b) const {
    const Point3 &p = first_.center, &q = b.center;
    const Vector3<Integer> to = {scale_(q.x) - scale_(p.x), scale_(q.y) - scale_(p.y), scale_(q.z) - scale_(p.z)};
    const Integer square = dot(to, to), ra = radius(), rb = scale_(b.radius);
    return {to, square, square + ra * ra - rb * rb};
  }
  Integer radius() const { return scale_(first_.radius); }
  /// Returns the sign of |left| − 2 radius |right|.
  int compare(const Vector3<Integer>& left, const Integer& right_square) const {
    const Integer diameter = 2 * radius(), difference = dot(left, left) - diameter * diameter * right_square;
    return difference.sign();
  }

 private:
  IntegerScale scale_;
  const Ball& first_;
};

template <typename Real>
Vector3<Real> scaled(const Real& s, const Vector3<Real>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
/// Returns 2 x (u × v)² for the orthocenter x of a triangle with edges u and v, relative to the first corner.
template <typename Real>
Vector3<Real> twice_center(const Edge<Real>& u, const Edge<Real>& v, const Vector3<Real>& normal) {
  return plus(scaled(u.lift, cross(v.to, normal)), scaled(v.lift, cross(normal, u.to)));
}
/// Returns 2 |x| |u × v|, as a vector, for the same x.
template <typename Real>
Vector3<Real> twice_distance(const Edge<Real>& u, const Edge<Real>& v) {
  return minus(scaled(u.lift, v.to), scaled(v.lift, u.to));
}
template <typename Real>
Vector3<Real> twice_center(const Edge<Real>& u, const Edge<Real>& v, const Edge<Real>& w) {
  return plus(plus(scaled(u.lift, cross(v.to, w.to)), scaled(v.lift, cross(w.to, u.to))),
              scaled(w.lift, cross(u.to, v.to)));
}

/// The range in which filters are valid, so that what underflows is far below their bounds: lengths are at most
/// `greatest`, and bounds at least `least_bound`, or `least_length` where lengths are compared.
constexpr double greatest = 0x1p60, least_bound = 0x1p-600, least_length = 0x1p-300;

bool is_in_range(const Ball& ball) { return ball.radius <= greatest; }
bool is_in_range(const RoundedEdge& edge) { return edge.length <= greatest; }
template <typename... Parts>
bool are_in_range(const Parts&... parts) {
  return (is_in_range(parts) && ...);
}

/// A length and a bound for its error.
struct Length {
  double value, error;
  Length(const Vector3<double>& v, double roundings) : Length(std::sqrt(dot(v, v)), roundings) {}
  Length(double length, double roundings) : value(length), error(roundings * roundoff + 8 * roundoff * length) {}
};

/// Returns the sign of left − 2 radius · right, or that of exact() if it is not certain.
template <typename Exactly>
int compare(const Length& left, double radius, const Length& right, bool is_in_range, Exactly exactly) {
  if (is_in_range && left.error > least_length && right.error > least_length) {
    if (left.value - left.error > 2 * radius * (right.value + right.error)) return 1;
    if (left.value + left.error < 2 * radius * (right.value - right.error)) return -1;
  }
  return exactly();
}

template <typename Exactly>
bool is_negative(double value, double bound, bool is_in_range, Exactly exactly) {
  if (is_in_range && bound > least_bound && std::abs(value) > bound) return value < 0;
  return exactly() < 0;
}

}  // namespace

int least_power_sign(const Ball& a, const Ball& b) {
  const RoundedEdge e(a, b);
  return compare({std::abs(e.lift), 8 * e.size}, a.radius, {e.length, 4 * e.length}, are_in_range(a, b, e), [&] {
    const Exact exact{&a, &b};
    const Edge<Integer> edge = exact.edge(b);
    return exact.compare({edge.lift, 0, 0}, edge.square);
  });
}

int least_power_sign(const Ball& a, const Ball& b, const Ball& c) {
  const RoundedEdge e(a, b), f(a, c);
  const Vector3<double> normal = cross(e.to, f.to);
  return compare({twice_distance(e, f), 10 * (e.size * f.length + f.size * e.length)}, a.radius,
                 {normal, 10 * e.length * f.length}, are_in_range(a, b, c, e, f), [&] {
                   const Exact exact{&a, &b, &c};
                   const Edge<Integer> u = exact.edge(b), v = exact.edge(c);
                   const Vector3<Integer> n = cross(u.to, v.to);
                   return exact.compare(twice_distance(u, v), dot(n, n));
                 });
}

int least_power_sign(const Ball& a, const Ball& b, const Ball& c, const Ball& d) {
  const RoundedEdge e(a, b), f(a, c), g(a, d);
  const double volume = dot(cross(e.to, f.to), g.to), ef = e.length * f.length;
  const double terms = g.length * (e.size * f.length + f.size * e.length) + g.size * ef;
  return compare({twice_center(e, f, g), 28 * terms}, a.radius, {std::abs(volume), 12 * ef * g.length},
                 are_in_range(a, b, c, d, e, f, g), [&] {
                   const Exact exact{&a, &b, &c, &d};
                   const Edge<Integer> u = exact.edge(b), v = exact.edge(c), w = exact.edge(d);
                   const Integer six_volumes = dot(cross(u.to, v.to), w.to);
                   return exact.compare(twice_center(u, v, w), six_volumes * six_volumes);
                 });
}

bool is_conflict(const Ball& a, const Ball& q) {
  const RoundedEdge e(a, q);
  return is_negative(e.lift, 8 * roundoff * e.size, are_in_range(a, q, e), [&] {
    return Exact{&a, &q}.edge(q).lift.sign();
  });
}

bool is_conflict(const Ball& a, const Ball& b, const Ball& q) {
  const auto power = [](const auto& e, const auto& d) {
    using Real = std::remove_cvref_t<decltype(d.lift)>;
    return Real(d.lift * e.square - e.lift * dot(e.to, d.to));
  };
  const RoundedEdge e(a, b), d(a, q);
  const double bound = 16 * roundoff * (d.size * e.square + e.size * e.length * d.length);
  return is_negative(power(e, d), bound, are_in_range(a, b, q, e, d), [&] {
    const Exact exact{&a, &b, &q};
    return power(exact.edge(b), exact.edge(q)).sign();
  });
}

bool is_conflict(const Ball& a, const Ball& b, const Ball& c, const Ball& q) {
  const auto power = [](const auto& e, const auto& f, const auto& d) {
    using Real = std::remove_cvref_t<decltype(d.lift)>;
    const Vector3<Real> normal = cross(e.to, f.to);
    return Real(d.lift * dot(normal, normal) - dot(twice_center(e, f, normal), d.to));
  };
  const RoundedEdge e(a, b), f(a, c), d(a, q);
  const double bound =
      96 * roundoff *
      (d.size * e.square * f.square + d.length * e.length * f.length * (e.size * f.length + f.size * e.length));
  return is_negative(power(e, f, d), bound, are_in_range(a, b, c, q, e, f, d), [&] {
    const Exact exact{&a, &b, &c, &q};
    return power(exact.edge(b), exact.edge(c), exact.edge(q)).sign();
  });
}

}  // namespace rbpa::space
