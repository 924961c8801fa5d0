// What: converts doubles to integers, all multiplied by one power of two.
// Law:  exact; an expression that is homogeneous in all converted values keeps its sign.
// Cost: grows with the span of the exponents.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace rbpa {

using Integer = boost::multiprecision::cpp_int;

class IntegerScale {
 public:
  /// Includes a finite value in the scale. Requires: all values are included before the first conversion; not checked.
  void include(double value) {
    if (value == 0) return;
    int exponent;
    std::frexp(value, &exponent);
    unit_ = std::min(unit_, exponent - 53);
  }

  /// Returns `value` over the power of two that makes all included values integers. Requires: it was included.
  Integer operator()(double value) const {
    if (value == 0) return 0;
    int exponent;
    const double fraction = std::frexp(value, &exponent);
    Integer mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    return mantissa << static_cast<unsigned>(exponent - 53 - unit_);
  }

  /// Returns the exponent of that power of two. Requires: a value other than 0 was included.
  int exponent() const { return unit_; }

 private:
  static constexpr int none = 1 << 20;  // beyond all exponents
  int unit_ = none;
};

}  // namespace rbpa
