// What: cube roots by operations whose rounding IEEE 754 defines; std::cbrt() and std::pow() depend on the C library.
// Law:  the bits depend on the number alone. The error is at most 1.2 units in the last place.
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
  // Newton's method begins on a line above the curve and descends until rounding stops it.
  Real root = Real(0.5) + Real(0.625) * scaled;
  while (true) {
    const Real next = root - (root - scaled / (root * root)) / 3;
    if (!(next < root)) return std::ldexp(root, third);
    root = next;
  }
}

}  // namespace rbpa
