// What: sums products of integers without any error, in three words.
// Cost: two multiplications and a few additions a term.
#pragma once

#include <cmath>
#include <cstdint>

#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/exact/integer128.h"

namespace rbpa {

class IntegerSum {
 public:
  /// Adds the product of a and b. Requires: |a| < 2¹²⁵, |b| < 2⁶²; fewer than 2⁶⁰ terms.
  void add_product(Integer128 a, std::int64_t b) {
    const Integer128 low = Integer128{b} * static_cast<std::uint64_t>(a),
                     high = Integer128{b} * static_cast<std::int64_t>(a >> 64);
    const Integer128 middle = high + (low >> 64);
    low_ += static_cast<std::uint64_t>(low);
    middle_ += static_cast<std::uint64_t>(middle);
    high_ += static_cast<std::int64_t>(middle >> 64);
  }

  /// Adds this sum times 2^exponent to `sum`. Requires: |exponent| < 1700.
  void add_to(ExactSum& sum, int exponent) const {
    add_digits(sum, low_, exponent, 1);
    add_digits(sum, middle_, exponent + 64, 1);
    add_digits(sum, high_ < 0 ? -high_ : high_, exponent + 128, high_ < 0 ? -1 : 1);
  }

 private:
  /// Adds sign · rest · 2^exponent to `sum`, in digits of 32 bits. Requires: rest ≥ 0.
  static void add_digits(ExactSum& sum, Integer128 rest, int exponent, int sign) {
    for (; rest != 0; rest >>= 32, exponent += 32) {
      const auto digit = sign * static_cast<std::int64_t>(rest & 0xffffffff);
      sum.add_product(std::ldexp(static_cast<double>(digit), exponent / 2), std::ldexp(1.0, exponent - exponent / 2));
    }
  }

  // The sum is low_ + 2⁶⁴ middle_ + 2¹²⁸ high_; low_ and middle_ are not negative.
  Integer128 low_ = 0, middle_ = 0, high_ = 0;
};

}  // namespace rbpa
