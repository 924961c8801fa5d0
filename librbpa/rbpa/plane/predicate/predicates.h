// What: the exact decisions: side of a line, in-circle, circumradius against alpha, distances.
// Law:  each predicate returns the sign of a real number that its comment names, for every finite input. Exchanging
//       arguments changes the sign as it does for the real number.
// How:  a floating filter with a proved bound decides nearly always (docs/explanation/exact_decisions.md derives the
//       bounds); the rest goes to integers of a fixed width where they fit, to double-double, to expansions, or to
//       integers of any length where exponents are extreme.
// Cost: a few nanoseconds; 0.1–1 µs when the filter fails.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/base/exact/expansion.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/predicate/exact_integer.h"
#include "rbpa/plane/predicate/fixed_width.h"

namespace rbpa {

/// The predicates on coordinates whose products stay within the exponents of `Real`:
///   double       coordinates for which fits_double() holds;
///   long double  every coordinate: with an exponent of 15 bits or more, products of six doubles stay in range.
template <typename Real>
class Predicates {
  static_assert(std::numeric_limits<Real>::is_iec559);
  static_assert(std::is_same_v<Real, double> || std::numeric_limits<Real>::max_exponent >= 16384,
                "long double has the exponents of double here: extreme coordinates could not be filtered");

 public:
  static constexpr Real unit_roundoff =
      std::numeric_limits<Real>::epsilon() / 2;  ///< the relative error of one rounding

  struct Vector {
    Real x, y;
  };
  static Vector from(const Point& a, const Point& b) { return {Real(b.x) - Real(a.x), Real(b.y) - Real(a.y)}; }
  static Real dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }
  static Real cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }
  static Real dot_magnitude(const Vector& u, const Vector& v) { return std::abs(u.x * v.x) + std::abs(u.y * v.y); }
  static Real cross_magnitude(const Vector& u, const Vector& v) { return std::abs(u.x * v.y) + std::abs(u.y * v.x); }

  /// Returns 1 if a, b, c turn left, −1 if right, 0 if they are on a line.
  static int orientation(const Point& a, const Point& b, const Point& c) {
    const Vector ab = from(a, b), ac = from(a, c);
    const Real area = cross(ab, ac), bound = 5 * unit_roundoff * cross_magnitude(ab, ac);
    if (area > bound) return 1;
    if (area < -bound) return -1;
    if (bound == 0) return 0;  // both products are 0, and not by underflow: a, b, c are on a line parallel to an axis
    if constexpr (std::is_same_v<Real, double>) {
      if (const FixedVectors<2> fixed(31, a, {&b, &c}); fixed.are_exact()) return sign_of(fixed[0].cross(fixed[1]));
      return exact(a, b).cross(exact(a, c)).sign();
    }
    return exact_integer::orientation(a, b, c);
  }

  /// Returns 1 if q is inside the circle of (a, b, p), −1 if outside, 0 if on it. Requires: (a, b, p) turns left.
  static int in_circle(const Point& a, const Point& b, const Point& p, const Point& q) {
    const CircleTest<Real> test(a, b, p, q);
    if (test.is_sure()) return test.sign();
    if constexpr (std::is_same_v<Real, double>) {
      // 29 bits: products of degree four are below 2^121.
      if (const FixedVectors<3> fixed(29, a, {&b, &p, &q}); fixed.are_exact()) {
        const FixedVector &ab = fixed[0], &ap = fixed[1], &aq = fixed[2];
        return sign_of(Integer128{ap.dot(ap - ab)} * ab.cross(aq) - Integer128{aq.dot(aq - ab)} * ab.cross(ap));
      }
      // The points are cocircular up to rounding. A few bits more nearly always decide.
      if constexpr (has_extended) {
        const CircleTest<long double> finer(a, b, p, q);
        if (finer.is_sure()) return finer.sign();
      }
      const auto wide_ab = widened(a, b), wide_ap = widened(a, p), wide_aq = widened(a, q);
      const DoubleDouble finer =
          wide_ap.dot(widened(b, p)) * wide_ab.cross(wide_aq) - wide_aq.dot(widened(b, q)) * wide_ab.cross(wide_ap);
      const double bound = 64 * unit_roundoff * unit_roundoff * test.magnitude;
      if (finer.high > bound) return 1;
      if (finer.high < -bound) return -1;
      const auto exact_ab = exact(a, b), exact_ap = exact(a, p), exact_aq = exact(a, q);
      return (exact_ap.dot(exact(b, p)) * exact_ab.cross(exact_aq) -
              exact_aq.dot(exact(b, q)) * exact_ab.cross(exact_ap))
          .sign();
    }
    return exact_integer::in_circle(a, b, p, q);
  }

  /// Returns in_circle() as if no four points were on a circle: q cocircular with (a, b, p) is moved off the circle by
  /// the symbolic perturbation (docs/explanation/exact_decisions.md). Requires: (a, b, p) turns left and q is none of
  /// these three.
  static int in_perturbed_circle(const Point& a, const Point& b, const Point& p, const Point& q) {
    const int side = in_circle(a, b, p, q);
    return side != 0 ? side : perturbed_side(a, b, p, q);
  }

  /// Returns 1 if the perturbation puts q inside the circle of (a, b, p), −1 if outside; never 0. The lexicographically
  /// largest of the four points is lifted most. If q is the largest, q leaves the circle; if a corner is the largest,
  /// the side depends on how the corner's lift tilts the circle. Requires: q is on the circle, and is not a, b or p.
  static int perturbed_side(const Point& a, const Point& b, const Point& p, const Point& q) {
    if (a < q && b < q && p < q) return -1;
    if (b < a && p < a) return orientation(q, b, p);
    return p < b ? orientation(a, q, p) : orientation(a, b, q);
  }

  /// Returns the sign of (circumradius of (a, b, c)) − alpha. Requires: a, b, c not on a line; alpha finite, and for
  /// double not less than the least radius of radius_bounds().
  static int compare_circumradius(const Point& a, const Point& b, const Point& c, double alpha) {
    const Vector ab = from(a, b), bc = from(b, c), ca = from(c, a);
    const Real sides = dot(ab, ab) * dot(bc, bc) * dot(ca, ca);
    const Real area = std::abs(cross(ab, ca)), area_magnitude = cross_magnitude(ab, ca);
    const Real factor = 4 * Real(alpha) * Real(alpha);
    const Real difference = sides - factor * area * area;
    const Real bound =
        unit_roundoff * (32 * sides + factor * area_magnitude * (24 * area + 64 * unit_roundoff * area_magnitude));
    // The sign is unpredictable at a radius like that of many triangles: only the undecided case is a branch.
    if (std::abs(difference) > bound) [[likely]]
      return difference > 0 ? 1 : -1;
    return compare_to_close_alpha(a, b, c, alpha);
  }
  /// Returns compare_circumradius() without its filter: faster where that filter would not decide.
  static int compare_to_close_alpha(const Point& a, const Point& b, const Point& c, double alpha) {
    if (const int finer = compare_circumradius_finely(a, b, c, alpha); finer != 0) return finer;
    return exact_integer::compare_circumradius(a, b, c, alpha);
  }

  /// Returns the sign of |ab| − 2 alpha. Requires: alpha as in compare_circumradius().
  static int compare_to_diameter(const Point& a, const Point& b, double alpha) {
    const Vector ab = from(a, b);
    const Real length = dot(ab, ab), diameter = 4 * Real(alpha) * Real(alpha);
    const Real bound = 8 * unit_roundoff * (length + diameter);
    if (length - diameter > bound) return 1;
    if (length - diameter < -bound) return -1;
    return exact_integer::compare_to_diameter(a, b, alpha);
  }

  /// Returns the sign of |vp| − |vq|.
  static int compare_distances(const Point& v, const Point& p, const Point& q) {
    const Vector vp = from(v, p), vq = from(v, q);
    const Real first = dot(vp, vp), second = dot(vq, vq);
    const Real bound = 8 * unit_roundoff * (first + second);
    if (first - second > bound) return 1;
    if (first - second < -bound) return -1;
    return exact_integer::compare_distances(v, p, q);
  }

  /// Returns the sign of (p − v) · (q − v): of the cosine of the angle at v.
  static int dot_sign(const Point& v, const Point& p, const Point& q) {
    const Vector vp = from(v, p), vq = from(v, q);
    const Real product = dot(vp, vq), bound = 5 * unit_roundoff * dot_magnitude(vp, vq);
    if (product > bound) return 1;
    if (product < -bound) return -1;
    return exact_integer::dot(v, p, q);
  }

 private:
  /// Whether long double has 64 bits and is computed by the processor, as on x86. A long double of 113 bits is computed
  /// in software, and slowly.
  static constexpr bool has_extended = std::numeric_limits<long double>::digits == 64;

  /// The test of in_circle() in numbers of one type, which decides only if is_sure() is true.
  template <typename Number>
  struct CircleTest {
    CircleTest(const Point& a, const Point& b, const Point& p, const Point& q) {
      using N = Predicates<Number>;
      const auto ab = N::from(a, b), ap = N::from(a, p), bp = N::from(b, p), aq = N::from(a, q), bq = N::from(b, q);
      difference = N::dot(ap, bp) * N::cross(ab, aq) - N::dot(aq, bq) * N::cross(ab, ap);
      magnitude =
          N::dot_magnitude(ap, bp) * N::cross_magnitude(ab, aq) + N::dot_magnitude(aq, bq) * N::cross_magnitude(ab, ap);
    }
    bool is_sure() const { return std::abs(difference) > 11 * Predicates<Number>::unit_roundoff * magnitude; }
    int sign() const { return difference > 0 ? 1 : -1; }

    Number difference, magnitude;
  };

  /// Returns compare_circumradius() by double-double numbers; 0 if these do not decide it.
  static int compare_circumradius_finely(const Point& a, const Point& b, const Point& c, double alpha) {
    const auto ab = widened(a, b), bc = widened(b, c), ca = widened(c, a);
    const DoubleDouble first = ab.dot(ab), second = bc.dot(bc), third = ca.dot(ca);
    // Within these bounds no product leaves the range of double, and an underflow in a product is below the bound:
    // docs/explanation/exact_decisions.md.
    constexpr double least = 0x1p-300, largest = 0x1p300;
    const double squared = alpha * alpha;
    const auto [shortest, longest] = std::minmax({first.high, second.high, third.high, squared});
    if (!(shortest > least && longest < largest)) return 0;
    const DoubleDouble sides = first * second * third, area = ab.cross(ca);
    const DoubleDouble twice = DoubleDouble{2 * alpha, 0} * area, difference = sides - twice * twice;
    const double magnitude = 2 * alpha * (std::abs(ab.x.high * ca.y.high) + std::abs(ab.y.high * ca.x.high));
    constexpr double square_of_roundoff = 0x1p-106;
    const double bound = 64 * square_of_roundoff *
                         (sides.high + magnitude * (std::abs(twice.high) + 8 * square_of_roundoff * magnitude));
    if (difference.high > bound) return 1;
    if (difference.high < -bound) return -1;
    return 0;
  }

  template <typename Number>
  static int sign_of(Number n) {
    return static_cast<int>(n > 0) - static_cast<int>(n < 0);
  }

  struct DoubleDoubleVector {
    DoubleDouble x, y;
    DoubleDouble dot(const DoubleDoubleVector& v) const { return x * v.x + y * v.y; }
    DoubleDouble cross(const DoubleDoubleVector& v) const { return x * v.y - y * v.x; }
  };
  static DoubleDoubleVector widened(const Point& a, const Point& b) {
    return {DoubleDouble::difference(b.x, a.x), DoubleDouble::difference(b.y, a.y)};
  }
  struct ExactVector {
    Expansion<2> x, y;
    Expansion<16> dot(const ExactVector& v) const { return x * v.x + y * v.y; }
    Expansion<16> cross(const ExactVector& v) const { return x * v.y - y * v.x; }
  };
  static ExactVector exact(const Point& a, const Point& b) { return {difference(b.x, a.x), difference(b.y, a.y)}; }
};

}  // namespace rbpa
