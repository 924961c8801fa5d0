// What: √(x² + y²) by operations that IEEE 754 rounds, as C libraries round std::hypot() differently.
// Law:  the bits are a function of the numbers alone. Error of a normal result: at most 0.51 units in the last place.
#pragma once

#include <algorithm>
#include <cmath>

#include "rbpa/base/exact/double_double.h"

namespace rbpa {

/// Returns √(x² + y²); infinity where the root is beyond the range of double. Requires: `x` and `y` are no NaN.
inline double hypotenuse(double x, double y) {
  const double larger = std::max(std::abs(x), std::abs(y));
  if (larger == 0 || std::isinf(larger)) return larger;
  const int exponent = std::ilogb(larger);
  const DoubleDouble u = {std::scalbn(x, -exponent), 0}, v = {std::scalbn(y, -exponent), 0}, square = u * u + v * v;
  const DoubleDouble root = {std::sqrt(square.high), 0};
  return std::scalbn(root.high + (square - root * root).high / (2 * root.high), exponent);
}

}  // namespace rbpa
