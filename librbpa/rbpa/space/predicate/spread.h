// What: the spread of the exponents of points in space, and the power of two that brings them into the range of double,
//       so that filters of degree five neither overflow nor underflow unnoticed.
// Law:  multiplied by 2^exponent no coordinate is above 2^150. Where is_exact, none is rounded, and all are multiples
//       of 2^unit, unit ≥ −150; otherwise underflow changes no value of degree five by more than `underflow`
//       (docs/explanation/exact_decisions.md, section 7).
// Cost: linear.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::space {

struct Spread {
  int exponent = 0;
  int unit = 0;
  bool is_exact = true;

  /// Returns the greatest error that underflow may cause in a polynomial of degree up to five.
  double underflow() const { return is_exact ? 0 : 0x1p-400; }
  /// Returns a bound: a product of `degree` differences whose computed error is below the bound has no error at all,
  /// because all numbers involved are multiples of 2^(unit degree) and have 53 bits. Returns 0 if there is none.
  double exact_below(int degree) const { return is_exact ? std::ldexp(16.0, unit * degree) : 0; }
};

/// Returns the spread of the points and radii. Requires: finite points and radii.
Spread spread(std::span<const Point3> points, std::span<const double> radii = {});

/// Multiplies the points, or the radii, by 2^exponent. Returns the values themselves where nothing changes, else those
/// in `copy`.
std::span<const Point3> scaled(std::span<const Point3> points, const Spread& spread, std::vector<Point3>& copy);
std::span<const double> scaled(std::span<const double> radii, const Spread& spread, std::vector<double>& copy);

}  // namespace rbpa::space
