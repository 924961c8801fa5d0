// What: finds the range of exponents of points in space, and a power of two that scales the points so that filters of
//       degree five neither overflow nor underflow unnoticed.
// Law:  after multiplication by 2^exponent no coordinate is above 2^150. If is_exact, no coordinate is rounded, and all
//       are multiples of 2^unit with unit ≥ −150; otherwise underflow changes no value of degree five by more than
//       underflow() (docs/explanation/exact_decisions.md, section 7).
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
  /// Returns a bound on computed errors: a sum of products of `degree` differences with an error below the bound has no
  /// error at all, because all terms are multiples of 2^(unit · degree) with at most 53 bits. Returns 0 if there is no
  /// such bound.
  double exact_below(int degree) const { return is_exact ? std::ldexp(16.0, unit * degree) : 0; }
};

/// Returns the spread of the points and radii. Requires: finite points and radii.
Spread spread(std::span<const Point3> points, std::span<const double> radii = {});

/// Returns the points, or the radii, times 2^exponent: the given span if the exponent is 0, else the values in `copy`.
std::span<const Point3> scaled(std::span<const Point3> points, const Spread& spread, std::vector<Point3>& copy);
std::span<const double> scaled(std::span<const double> radii, const Spread& spread, std::vector<double>& copy);

}  // namespace rbpa::space
