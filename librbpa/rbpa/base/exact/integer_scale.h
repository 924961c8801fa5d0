// What: converts doubles to integers: multiplies all of them by one power of two.
// Law:  the conversion is exact; an expression that is homogeneous in all converted values keeps its sign.
// Cost: grows with the span of the exponents. An integer has up to 53 bits more than this span, and at most 2,150.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace rbpa {

using Integer = boost::multiprecision::cpp_int;

class IntegerScale {
 public:
  /// Includes a finite value in the scale. Requires: the first conversion comes after the last include(); not checked.
  void include(double value) {
    if (value == 0) return;
    int exponent;
    std::frexp(value, &exponent);
    unit_ = std::min(unit_, exponent - 53);
  }

  /// Returns `value` / 2^exponent(), an integer. The included value of least absolute value other than 0 becomes an
  /// integer of 53 bits: 1 alone becomes 2^52. Requires: `value` is 0 or was included; not checked.
  Integer operator()(double value) const {
    if (value == 0) return 0;
    int exponent;
    const double fraction = std::frexp(value, &exponent);
    Integer mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    return mantissa << static_cast<unsigned>(exponent - 53 - unit_);
  }

  /// Returns the exponent of the power of two that divides values. Requires: a value other than 0 was included; not
  /// checked.
  int exponent() const { return unit_; }

 private:
  static constexpr int none = 1 << 20;  // beyond all exponents
  int unit_ = none;
};

}  // namespace rbpa
