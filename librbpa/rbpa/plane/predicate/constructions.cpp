#include "rbpa/plane/predicate/constructions.h"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/base/exact/integer_scale.h"

namespace rbpa {
namespace {

/// Returns whether products of five such differences, and their last bits, stay within the exponents of double.
bool has_usual_size(double difference) {
  const double size = std::abs(difference);
  return size == 0 || (size > 0x1p-150 && size < 0x1p150);
}

/// A number with a bound of its error; an infinite bound if the exponents do not allow a proof.
struct Bounded {
  DoubleDouble value;
  double error = 0;

  static Bounded difference(double a, double b) {
    const DoubleDouble exact = DoubleDouble::difference(a, b);
    return {exact, has_usual_size(exact.high) ? 0 : std::numeric_limits<double>::infinity()};
  }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return {a.value + b.value, (a.error + b.error) * grown + roundoff * (a.size() + b.size())};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return {a.value - b.value, (a.error + b.error) * grown + roundoff * (a.size() + b.size())};
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const double inherited = a.size() * b.error + b.size() * a.error + a.error * b.error;
    return {a.value * b.value, inherited * grown + roundoff * a.size() * b.size()};
  }
  double size() const { return std::abs(value.high); }
  bool is_sure() const { return size() > 2 * error; }

 private:
  static constexpr double grown = 1 + 0x1p-40;       ///< covers the rounding of error bounds
  static constexpr double roundoff = 16 * 0x1p-106;  ///< above the bounds of double_double.h
};

/// Differences of coordinates in numbers with a bound.
struct InBounded {
  using Number = Bounded;
  Number operator()(double a, double b) const { return Bounded::difference(a, b); }
};

/// Differences of coordinates in integers, which are multiplied by one power of two.
struct InIntegers {
  using Number = Integer;
  IntegerScale scale = {};
  explicit InIntegers(std::initializer_list<Point> points) {
    for (const Point& p : points) include(p);
  }
  void include(const Point& p) {
    scale.include(p.x);
    scale.include(p.y);
  }
  Number operator()(double a, double b) const { return scale(a) - scale(b); }
};

template <typename Number>
struct Way {
  Number x, y;
  template <typename Differences>
  Way(const Differences& of, const Point& from, const Point& to) : x(of(to.x, from.x)), y(of(to.y, from.y)) {}
  Number dot(const Way& v) const { return x * v.x + y * v.y; }
  Number cross(const Way& v) const { return x * v.y - y * v.x; }
};
template <typename Differences>
Way(const Differences&, const Point&, const Point&) -> Way<typename Differences::Number>;

/// The point that is (x, y) / divisor from `origin`.
template <typename Number>
struct Quotient {
  Point origin;
  Number x, y, divisor;
};

template <typename Differences>
Quotient<typename Differences::Number> center_of(const Differences& of, const Point& a, const Point& b,
                                                 const Point& c) {
  using Number = typename Differences::Number;
  const Way u(of, a, b), v(of, a, c);
  const Number uu = u.dot(u), vv = v.dot(v), area = u.cross(v);
  return {a, v.y * uu - u.y * vv, u.x * vv - v.x * uu, area + area};
}

template <typename Differences>
Quotient<typename Differences::Number> crossing_of(const Differences& of, const Line& one, const Line& other) {
  const Way along(of, one.from, one.to), across(of, other.from, other.to), between(of, one.from, other.from);
  const auto share = between.cross(across);
  return {one.from, along.x * share, along.y * share, along.cross(across)};
}

template <typename Differences>
Quotient<typename Differences::Number> crossing_of(const Differences& of, const Point& p, const Point& q,
                                                   const Line& line) {
  using Number = typename Differences::Number;
  const Way chord(of, p, q), along(of, line.from, line.to), to_line(of, p, line.from);
  const Number over = to_line.dot(chord), share = chord.dot(chord) - (over + over), under = along.dot(chord);
  return {line.from, along.x * share, along.y * share, under + under};
}

/// Returns over / under · 2^exponent, rounded to nearest, ties to even.
double rounded_quotient(Integer over, Integer under, int exponent) {
  if (over == 0) return 0;
  const int sign = over.sign() * under.sign();
  over = abs(over);
  under = abs(under);
  // The quotient in quarters of the last place of the result, with a last bit that is 1 if anything is below.
  const int leading = static_cast<int>(msb(over)) - static_cast<int>(msb(under)) - 1;
  const int place = std::max(leading + exponent - 54, -1076), shift = exponent - place;
  (shift > 0 ? over : under) <<= static_cast<unsigned>(std::abs(shift));
  Integer whole, rest;
  divide_qr(over, under, whole, rest);
  auto quarters = static_cast<std::uint64_t>(whole);
  const bool is_long = (quarters >> 55U) != 0;
  if (is_long) quarters = quarters >> 1U | (quarters & 1U);
  if (rest != 0) quarters |= 1U;
  const std::uint64_t down = quarters >> 2U, part = quarters & 3U;
  const std::uint64_t nearest = down + static_cast<std::uint64_t>(part == 3 || (part == 2 && down % 2 != 0));
  return std::ldexp(sign * static_cast<double>(nearest), place + 2 + static_cast<int>(is_long));
}

/// Returns origin + over / under, rounded, if the bounds prove that it is; NaN otherwise.
double rounded_sum(double origin, const Bounded& over, const Bounded& under) {
  double result = origin + over.value.high / under.value.high;
  for (int i = 0; i < 2; ++i) {
    const Bounded left = over - Bounded::difference(result, origin) * under;
    const double half = std::abs(result - std::nextafter(result, 0)) / 2;  // the lesser of the gaps to both sides
    if (left.size() + left.error < half * (under.size() - under.error) * (1 - 0x1p-40)) return result;
    result += left.value.high / under.value.high;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Returns origin + over / under, rounded, if it is certain; NaN otherwise. `error` bounds the error of over / under.
double certain_sum(double origin, double over, double under, double error) {
  const double quotient = over / under;
  const auto [result, rest] = detail::two_sum(origin, quotient);
  constexpr std::uint64_t exponent = 0x7ff0'0000'0000'0000;
  const double power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(result) & exponent);
  const double half_gap = power * (std::abs(result) == power ? 0x1p-54 : 0x1p-53);  // the lesser of both gaps
  return std::abs(rest) + error < half_gap * (1 - 0x1p-40) ? result : std::numeric_limits<double>::quiet_NaN();
}

/// Returns the circumcenter in double, a coordinate that is not certain as NaN. Let r = 2⁻⁵³, and let the sizes be the
/// sums of the absolute values of products. The errors of numerators are below 8 r times their sizes, that of the
/// cross product below 5 r times its size, which is less than a tenth of it. So the error of a quotient q is below
/// 9 r size / |divisor| + 11 r |q| cross_size / |divisor| + r |q|; what is added here exceeds the rounding of the
/// bound.
Point quick_circumcenter(const Point& a, const Point& b, const Point& c) {
  constexpr double r = 0x1p-53, nan = std::numeric_limits<double>::quiet_NaN();
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  if (!(has_usual_size(ux) && has_usual_size(uy) && has_usual_size(vx) && has_usual_size(vy))) return {nan, nan};
  const double uu = ux * ux + uy * uy, vv = vx * vx + vy * vy;
  const double cross_size = std::abs(ux * vy) + std::abs(uy * vx), divisor = 2 * (ux * vy - uy * vx);
  if (!(divisor > 128 * r * cross_size)) return {nan, nan};
  const double x = vy * uu - uy * vv, y = ux * vv - vx * uu;
  const double x_size = std::abs(vy) * uu + std::abs(uy) * vv, y_size = std::abs(ux) * vv + std::abs(vx) * uu;
  const auto error = [&](double over, double size) {
    return (10 * r * size + (12 * r * cross_size / divisor + 2 * r) * std::abs(over)) / divisor;
  };
  return {certain_sum(a.x, x, divisor, error(x, x_size)), certain_sum(a.y, y, divisor, error(y, y_size))};
}

/// Returns the point that `construct` computes from differences of `points`, rounded.
template <typename Construct>
Point rounded_point(std::initializer_list<Point> points, const Construct& construct) {
  const Quotient<Bounded> quick = construct(InBounded());
  if (quick.divisor.is_sure()) {
    const Point result = {rounded_sum(quick.origin.x, quick.x, quick.divisor),
                          rounded_sum(quick.origin.y, quick.y, quick.divisor)};
    if (is_finite(result)) return result;
  }
  const InIntegers exact(points);
  const Quotient<Integer> q = construct(exact);
  const auto coordinate = [&](double origin, const Integer& over) {
    return rounded_quotient(exact.scale(origin) * q.divisor + over, q.divisor, exact.scale.exponent());
  };
  return {coordinate(q.origin.x, q.x), coordinate(q.origin.y, q.y)};
}

/// Returns the sign of the number that `compute` makes of differences.
template <typename Compute>
int sign_of(std::initializer_list<Point> points, const Compute& compute) {
  const Bounded quick = compute(InBounded());
  return quick.is_sure() ? (quick.value.high > 0 ? 1 : -1) : Integer(compute(InIntegers(points))).sign();
}

}  // namespace

Point circumcenter(const Point& a, const Point& b, const Point& c) {
  const Point quick = quick_circumcenter(a, b, c);
  if (is_finite(quick)) return quick;
  return rounded_point({a, b, c}, [&](const auto& of) { return center_of(of, a, b, c); });
}

Point crossing(const Line& one, const Line& other) {
  return rounded_point({one.from, one.to, other.from, other.to},
                       [&](const auto& of) { return crossing_of(of, one, other); });
}

Point crossing_of_bisector(const Point& p, const Point& q, const Line& line) {
  return rounded_point({p, q, line.from, line.to}, [&](const auto& of) { return crossing_of(of, p, q, line); });
}

int side_of_circumcenter(const Line& line, const Point& a, const Point& b, const Point& c) {
  return sign_of({a, b, c, line.from, line.to}, [&](const auto& of) {
    const auto center = center_of(of, a, b, c);
    const Way along(of, line.from, line.to), way(of, line.from, a);
    return decltype(center.x)(along.cross(way) * center.divisor + (along.x * center.y - along.y * center.x));
  });
}

int dot_sign(const Line& line, const Point& p, const Point& q) {
  return sign_of({line.from, line.to, p, q},
                 [&](const auto& of) { return Way(of, line.from, line.to).dot(Way(of, p, q)); });
}

std::vector<std::size_t> order_along_bisector(const Point& p, const Point& q, std::span<const Line> lines) {
  using Rational = boost::multiprecision::cpp_rational;
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (lines.size() < 2) return order;
  InIntegers of{p, q};
  for (const Line& line : lines) {
    of.include(line.from);
    of.include(line.to);
  }
  // The bisector is (p + q) / 2 + s · n, where n is p − q turned right. A line meets it at s = d × (from − (p + q) / 2)
  // / d × n, where d is the line's direction; the two other numbers are the changes of s by ε and by ε².
  const Way chord(of, q, p);
  std::vector<std::array<Rational, 3>> keys;
  for (const Line& line : lines) {
    const Way along(of, line.from, line.to), from_p(of, p, line.from), from_q(of, q, line.from);
    const Integer under = -along.dot(chord), over = along.cross(from_p) + along.cross(from_q);
    const Rational share(1 / Rational(under));
    keys.push_back({Rational(over * share / 2), Rational(-along.y * share), Rational(along.x * share)});
  }
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return keys[i] < keys[j]; });
  return order;
}

}  // namespace rbpa
