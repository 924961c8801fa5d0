// What: √(x² + y²) by operations whose rounding IEEE 754 defines; std::hypot() depends on the C library.
// Law:  the bits depend on the numbers alone. The error of a normal result is at most 0.51 units in the last place.
#pragma once

#include <algorithm>
#include <cmath>

#include "rbpa/base/exact/double_double.h"

namespace rbpa {

/// Returns √(x² + y²); infinity if the root is beyond the range of double. Requires: neither `x` nor `y` is NaN.
inline double hypotenuse(double x, double y) {
  const double larger = std::max(std::abs(x), std::abs(y));
  if (larger == 0 || std::isinf(larger)) return larger;
  const int exponent = std::ilogb(larger);
  const DoubleDouble u = {std::scalbn(x, -exponent), 0}, v = {std::scalbn(y, -exponent), 0}, square = u * u + v * v;
  const DoubleDouble root = {std::sqrt(square.high), 0};
  return std::scalbn(root.high + (square - root * root).high / (2 * root.high), exponent);
}

}  // namespace rbpa
