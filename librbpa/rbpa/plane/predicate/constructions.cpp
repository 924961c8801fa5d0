#include "rbpa/plane/predicate/constructions.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numeric>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/base/exact/integer_scale.h"

namespace rbpa {
namespace {

/// A number with a bound of its error; an infinite bound if the exponents do not allow a proof.
struct Bounded {
  DoubleDouble value;
  double error = 0;

  static Bounded difference(double a, double b) {
    const DoubleDouble exact = DoubleDouble::difference(a, b);
    // Products of five such numbers, and their last bits, stay within the exponents of double.
    const double size = std::abs(exact.high);
    return {exact, size == 0 || (size > 0x1p-150 && size < 0x1p150) ? 0 : std::numeric_limits<double>::infinity()};
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

/// Returns the point that `construct` makes of differences, rounded. `points` has all points that it uses.
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
