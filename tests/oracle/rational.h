// What: doubles as rational numbers.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace rbpa_test {

using Rational = boost::multiprecision::cpp_rational;

/// Returns the exact value of a finite double.
inline Rational rational(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const boost::multiprecision::cpp_int digits = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  boost::multiprecision::cpp_int power = 1;
  power <<= static_cast<unsigned>(std::abs(exponent - 53));
  return exponent >= 53 ? Rational(digits * power) : Rational(digits, power);
}

}  // namespace rbpa_test
