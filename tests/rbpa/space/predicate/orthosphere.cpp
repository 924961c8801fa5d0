#include "rbpa/space/predicate/orthosphere.h"

#include <doctest/doctest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "support/random.h"

using rbpa::space::Ball;
using rbpa::space::is_conflict;
using rbpa::space::least_power_rounded_up;
using rbpa::space::least_power_sign;
using rbpa_test::Random;

TEST_SUITE_BEGIN("space");

namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 3>;

Vector exact(const Ball& b) { return {Rational(b.center.x), Rational(b.center.y), Rational(b.center.z)}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Rational power(const Vector& x, const Ball& b) {
  const Vector to = minus(x, exact(b));
  return dot(to, to) - Rational(b.radius) * Rational(b.radius);
}

/// Returns the orthocenter by definition: the point c0 + Σ t_k e_k of the centers' flat with the same power to all.
/// False if the centers are dependent.
bool orthocenter(std::span<const Ball> balls, Vector& center) {
  const std::size_t n = balls.size() - 1;
  std::vector<Vector> edges;
  for (std::size_t k = 1; k <= n; ++k) edges.push_back(minus(exact(balls[k]), exact(balls[0])));
  std::vector<std::vector<Rational>> m(n, std::vector<Rational>(n + 1));
  center = exact(balls[0]);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t l = 0; l < n; ++l) m[k][l] = 2 * dot(edges[k], edges[l]);
    m[k][n] = power(center, balls[k + 1]) - power(center, balls[0]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && m[pivot][k] == 0) ++pivot;
    if (pivot == n) return false;
    std::swap(m[k], m[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == k) continue;
      const Rational factor = m[r][k] / m[k][k];
      for (std::size_t c = k; c <= n; ++c) m[r][c] -= factor * m[k][c];
    }
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) center[axis] += m[k][n] / m[k][k] * edges[k][axis];
  return true;
}

/// Checks that the value is the least double that is not below the power, or whose signed square is not below it.
void check_rounded_up(const Rational& power, double value, bool is_root) {
  constexpr double greatest = std::numeric_limits<double>::max();
  const auto is_reached = [&](double v) {
    return power <= (is_root ? Rational(v) * Rational(std::abs(v)) : Rational(v));
  };
  CHECK(!std::signbit(value) == (power > 0 || value == 0));
  CHECK((std::isinf(value) || is_reached(value)));
  CHECK((value == -greatest || !is_reached(std::nextafter(value, -greatest))));
}

void check(const std::array<Ball, 5>& balls) {
  const Ball &a = balls[0], &b = balls[1], &c = balls[2], &d = balls[3], &q = balls[4];
  Vector x;
  const auto expected_power = [&] { return power(x, a).sign(); };
  const auto expected_conflict = [&] { return power(x, q) < power(x, a); };
  x = exact(a);
  CHECK(is_conflict(a, q) == expected_conflict());
  const std::span<const Ball> all = balls;
  if (orthocenter(all.first(2), x)) {
    CHECK(least_power_sign(a, b) == expected_power());
    CHECK(is_conflict(a, b, q) == expected_conflict());
  }
  if (orthocenter(all.first(3), x)) {
    CHECK(least_power_sign(a, b, c) == expected_power());
    CHECK(is_conflict(a, b, c, q) == expected_conflict());
  }
  if (orthocenter(all.first(4), x)) CHECK(least_power_sign(a, b, c, d) == expected_power());
  for (std::size_t count = 1; count <= 4; ++count)
    if (orthocenter(all.first(count), x))
      for (const bool is_root : {false, true})
        check_rounded_up(power(x, a), least_power_rounded_up(all.first(count), is_root), is_root);
}

}  // namespace

TEST_CASE("least powers and conflicts of balls are those of the definition in rational numbers") {
  Random random(1);
  for (int set = 0; set < 1600; ++set) {
    // Integers have ties; tenths have near ties; powers of ten have lost digits, overflow and
    // underflow.
    const int kind = set % 8;
    const double unit = kind == 1   ? 0.1
                        : kind == 4 ? 1e-70
                        : kind == 5 ? 1e150
                        : kind == 6 ? 1e-162
                        : kind == 7 ? 1e155
                                    : 1;
    std::array<Ball, 5> balls;
    for (Ball& ball : balls) {
      const auto number = [&] {
        if (kind == 2) return random.between(-1, 1);
        if (kind == 3) return random.integer(-2, 2) + random.integer(-1, 1) * std::pow(10, random.integer(-17, -7));
        return unit * random.integer(-3, 3);
      };
      ball = {{number(), number(), number()}, std::abs(number())};
    }
    check(balls);
  }
}

TEST_SUITE_END();
