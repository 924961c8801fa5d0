// What:   double-double: numbers of twice the precision of double, each the unevaluated sum of two doubles.
// Law:    let u = 2⁻⁵³. A difference of doubles is exact. The error of a product is at most 9u² times its size, that of
//         a sum or difference at most 4u² times the sum of both sizes: docs/explanation/exact_decisions.md. No bound is
//         proved for a quotient. Requires: no product overflows or underflows (fits_double(), magnitude.h).
// Cost:   24 operations a product.
// Source: Dekker, A floating-point technique for extending the available precision (1971).
#pragma once

#include "rbpa/base/exact/expansion.h"

namespace rbpa {

/// The number high + low, with |low| ≤ u |high|, where u = 2⁻⁵³.
struct DoubleDouble {
  double high, low;

  static DoubleDouble difference(double a, double b) {
    const auto sum = detail::two_sum(a, -b);
    return {sum.high, sum.low};
  }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const auto sum = detail::two_sum(a.high, b.high);
    const auto whole = detail::two_sum(sum.high, sum.low + (a.low + b.low));
    return {whole.high, whole.low};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + DoubleDouble{-b.high, -b.low};
  }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const auto product = detail::two_product(a.high, b.high);
    const double rest = product.low + (a.high * b.low + a.low * b.high), sum = product.high + rest;
    return {sum, rest - (sum - product.high)};
  }
  /// Divides by two steps of long division.
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - DoubleDouble{first, 0} * b;
    const auto sum = detail::two_sum(first, rest.high / b.high);
    return {sum.high, sum.low};
  }
};

}  // namespace rbpa
