#include "rbpa/space/predicate/orthosphere.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/base/exact/integer_scale.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

constexpr double roundoff = 0x1p-53;

/// The edge from a first ball to another one. Powers to both are equal at x, relative to the first center, if 2 x · to
/// = lift.
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
  double length, size;  // size: sum of the absolute values of the terms of lift
};

/// Returns 2 x (u × v)² for the orthocenter x, relative to the first center, of three balls with edges u and v.
template <typename Real>
Vector3<Real> twice_center(const Edge<Real>& u, const Edge<Real>& v, const Vector3<Real>& normal) {
  return plus(times(u.lift, cross(v.to, normal)), times(v.lift, cross(normal, u.to)));
}
/// Returns a vector of length 2 |x| |u × v| for the orthocenter x, relative to the first center, of three balls.
template <typename Real>
Vector3<Real> twice_distance(const Edge<Real>& u, const Edge<Real>& v) {
  return minus(times(u.lift, v.to), times(v.lift, u.to));
}
template <typename Real>
Vector3<Real> twice_center(const Edge<Real>& u, const Edge<Real>& v, const Edge<Real>& w) {
  return plus(plus(times(u.lift, cross(v.to, w.to)), times(v.lift, cross(w.to, u.to))),
              times(w.lift, cross(u.to, v.to)));
}

/// The power at the orthocenter of two to four balls: left² / (4 square) − radius², with the radius of the first ball.
template <typename Real>
struct LeastPower {
  Vector3<Real> left;
  Real square;
};
template <typename Edges>
auto least_power(std::size_t balls, const Edges& edge) {
  const auto u = edge(1);
  using Real = std::remove_cvref_t<decltype(u.lift)>;
  if (balls == 2) return LeastPower<Real>{{u.lift, {}, {}}, u.square};
  const auto v = edge(2);
  const Vector3<Real> normal = cross(u.to, v.to);
  if (balls == 3) return LeastPower<Real>{twice_distance(u, v), dot(normal, normal)};
  const auto w = edge(3);
  const Real six_volumes = dot(normal, w.to);
  return LeastPower<Real>{twice_center(u, v, w), six_volumes * six_volumes};
}

/// Balls with integers as coordinates and radii.
class Exact {
 public:
  Exact(std::initializer_list<const Ball*> balls) : balls_(balls) { include_all(); }
  explicit Exact(std::span<const Ball> balls) {
    for (const Ball& ball : balls) balls_.push_back(&ball);
    include_all();
  }
  Edge<Integer> edge(const Ball& b) const {
    const Point3 &p = balls_[0]->center, &q = b.center;
    const Vector3<Integer> to = {scale_(q.x) - scale_(p.x), scale_(q.y) - scale_(p.y), scale_(q.z) - scale_(p.z)};
    const Integer square = dot(to, to), ra = scale_(balls_[0]->radius), rb = scale_(b.radius);
    return {to, square, square + ra * ra - rb * rb};
  }
  int least_power_sign() const { return ratio().above.sign(); }
  double least_power_rounded_up(bool is_root) const {
    auto [above, below] = ratio();
    return above == 0 ? 0 : rounded_up(std::move(above), std::move(below), 2 * scale_.exponent(), is_root);
  }

 private:
  /// The least power is above / below, in squared units of the scale.
  struct Ratio {
    Integer above, below;
  };

  void include_all() {
    for (const Ball* ball : balls_)
      for (const double value : {ball->center.x, ball->center.y, ball->center.z, ball->radius}) scale_.include(value);
  }
  Ratio ratio() const {
    const Integer radius = scale_(balls_[0]->radius);
    if (balls_.size() == 1) return {-radius * radius, 1};
    const auto [left, square] = least_power(balls_.size(), [&](std::size_t k) { return edge(*balls_[k]); });
    const Integer below = 4 * square;
    return {dot(left, left) - radius * radius * below, below};
  }
  /// Returns the least double that is not below above / below · 2^exponent or, if `is_root`, not below the signed root
  /// of this number. Requires: above ≠ 0.
  static double rounded_up(Integer above, Integer below, int exponent, bool is_root) {
    constexpr int enough = 110, digits = std::numeric_limits<double>::digits;  // the root of 2¹⁰⁹ has 55 bits
    const bool is_negative = above < 0;
    above = abs(above);
    int shift = enough - static_cast<int>(msb(above)) + static_cast<int>(msb(below));
    if ((exponent - shift) % 2 != 0) ++shift;
    (shift > 0 ? above : below) <<= static_cast<unsigned>(std::abs(shift));
    exponent -= shift;
    Integer quotient, rest;
    divide_qr(above, below, quotient, rest);
    bool is_rounded = rest != 0;
    if (is_root) {
      quotient = sqrt(Integer(quotient), rest);
      is_rounded |= rest != 0;
      exponent /= 2;
    }
    const int bits = static_cast<int>(msb(quotient)) + 1;
    const int dropped = std::max(bits - digits, std::numeric_limits<double>::min_exponent - digits - exponent);
    Integer kept = quotient >> static_cast<unsigned>(dropped);
    is_rounded |= Integer(kept << static_cast<unsigned>(dropped)) != quotient;
    if (is_rounded && !is_negative) ++kept;
    const double size = std::ldexp(kept.convert_to<double>(), exponent + dropped);
    return is_negative ? 0 - std::min(size, std::numeric_limits<double>::max()) : size;
  }

  IntegerScale scale_;
  std::vector<const Ball*> balls_;
};

/// Limits within which filters are valid, because errors by underflow are far below the bounds: lengths and radii are
/// at most `greatest`; error bounds are above `least_bound`, or above `least_length` where lengths are compared.
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

/// Returns the sign of left − 2 radius · right if it is certain, else exactly().
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

struct WideEdge : Edge<DoubleDouble> {
  WideEdge(const Ball& a, const Ball& b) {
    to = {DoubleDouble::difference(b.center.x, a.center.x), DoubleDouble::difference(b.center.y, a.center.y),
          DoubleDouble::difference(b.center.z, a.center.z)};
    square = dot(to, to);
    const DoubleDouble weights =
        DoubleDouble::difference(a.radius, b.radius) * DoubleDouble::difference(a.radius, -b.radius);
    lift = square + weights;
    length = std::sqrt(square.high);
    size = square.high + std::abs(weights.high);
  }
  double length, size;
};

/// Returns least_power_rounded_up() by double-double, or nothing if the result is not certain. Requires: at least two
/// balls. docs/explanation/exact_decisions.md, section 8, derives the errors.
std::optional<double> try_least_power(std::span<const Ball> balls, bool is_root) {
  constexpr double square_of_roundoff = roundoff * roundoff, least_square = 0x1p-500;
  std::vector<WideEdge> edges;
  for (std::size_t k = 1; k < balls.size(); ++k) edges.emplace_back(balls[0], balls[k]);
  if (!std::all_of(balls.begin(), balls.end(), [](const Ball& ball) { return is_in_range(ball); }) ||
      !std::all_of(edges.begin(), edges.end(), [](const WideEdge& edge) { return edge.length <= greatest; }))
    return {};
  const auto [left, square] = least_power(balls.size(), [&](std::size_t k) -> const WideEdge& { return edges[k - 1]; });
  if (!(square.high > least_square)) return {};
  double terms = edges[0].size, lengths = edges[0].length;  // bounds of the terms of |left|, and of √square
  for (std::size_t k = 1; k < edges.size(); ++k) {
    terms = terms * edges[k].length + edges[k].size * lengths;
    lengths *= edges[k].length;
  }
  const double left_error = 160 * square_of_roundoff * terms;
  const double right_error = balls.size() == 2 ? 0 : 96 * square_of_roundoff * lengths;
  const DoubleDouble radius{balls[0].radius, 0}, weight = radius * radius, four{4, 0};
  const DoubleDouble squares = dot(left, left), denominator = four * square;
  const double size = std::sqrt(squares.high), right = std::sqrt(square.high);
  // Returns the sign of (least power) − (power that `value` stands for); 0 if the sign is not certain.
  const auto compare = [&](double value) {
    const DoubleDouble power =
        is_root ? DoubleDouble{value, 0} * DoubleDouble{std::abs(value), 0} : DoubleDouble{value, 0};
    const double difference = (squares - denominator * (weight + power)).high, sum = weight.high + std::abs(power.high);
    const double error = 1.01 * (2 * (size + left_error) * left_error + 8 * sum * (right + right_error) * right_error) +
                         96 * square_of_roundoff * (squares.high + denominator.high * sum);
    return !(error > least_bound) ? 0 : difference > error ? 1 : difference < -error ? -1 : 0;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double power = (squares / denominator - weight).high;
  const double value = is_root ? std::copysign(std::sqrt(std::abs(power)), power) : power;
  const int sign = compare(value);
  const double next = std::nextafter(value, sign > 0 ? infinity : -infinity);
  if (sign == 0 || compare(next) != -sign) return {};
  return sign > 0 ? next : value;
}

}  // namespace

int least_power_sign(const Ball& a, const Ball& b) {
  const RoundedEdge e(a, b);
  return compare({std::abs(e.lift), 8 * e.size}, a.radius, {e.length, 4 * e.length}, are_in_range(a, b, e), [&] {
    return Exact{&a, &b}.least_power_sign();
  });
}

int least_power_sign(const Ball& a, const Ball& b, const Ball& c) {
  const RoundedEdge e(a, b), f(a, c);
  const Vector3<double> normal = cross(e.to, f.to);
  return compare({twice_distance(e, f), 10 * (e.size * f.length + f.size * e.length)}, a.radius,
                 {normal, 10 * e.length * f.length}, are_in_range(a, b, c, e, f), [&] {
                   return Exact{&a, &b, &c}.least_power_sign();
                 });
}

int least_power_sign(const Ball& a, const Ball& b, const Ball& c, const Ball& d) {
  const RoundedEdge e(a, b), f(a, c), g(a, d);
  const double volume = dot(cross(e.to, f.to), g.to), ef = e.length * f.length;
  const double terms = g.length * (e.size * f.length + f.size * e.length) + g.size * ef;
  return compare({twice_center(e, f, g), 28 * terms}, a.radius, {std::abs(volume), 12 * ef * g.length},
                 are_in_range(a, b, c, d, e, f, g), [&] {
                   return Exact{&a, &b, &c, &d}.least_power_sign();
                 });
}

double least_power_rounded_up(std::span<const Ball> balls, bool is_root) {
  if (balls.size() == 1 && is_root) return 0 - balls[0].radius;
  const std::optional<double> value = balls.size() == 1 ? std::nullopt : try_least_power(balls, is_root);
  return value ? *value : Exact(balls).least_power_rounded_up(is_root);
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
