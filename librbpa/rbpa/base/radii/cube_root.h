// What: cube roots by operations that IEEE 754 rounds, as C libraries round std::cbrt() and std::pow() differently.
// Law:  the bits are a function of the number alone. The error is at most 1.2 units in the last place.
#pragma once

#include <cmath>

namespace rbpa {

/// Returns the cube root of `x`. Requires: `x` is finite and not negative.
template <typename Real>
Real cube_root(Real x) {
  if (x == 0) return x;
  int exponent = 0;
  const Real mantissa = std::frexp(x, &exponent);
  const int third = (exponent > 0 ? exponent + 2 : exponent) / 3;
  const Real scaled = std::ldexp(mantissa, exponent - 3 * third);  // 1/8 to 1
  // Newton's steps descend from a line above the curve until rounding stops them.
  Real root = Real(0.5) + Real(0.625) * scaled;
  while (true) {
    const Real next = root - (root - scaled / (root * root)) / 3;
    if (!(next < root)) return std::ldexp(root, third);
    root = next;
  }
}

}  // namespace rbpa
