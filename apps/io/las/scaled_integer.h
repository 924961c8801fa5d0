// What: a coordinate of LAS: an integer times a scale, and an offset.
// Law:  where scale and offset are short decimals, as 0.01 and 500000 are, the double nearest to the exact decimal: what
//       one reads from the same points as text. Points on a grid stay on it, and on a line or circle as far as doubles
//       can say. Else value · scale + offset, each rounded, as the specification has it.
// Cost: two multiplications and a division, or two operations.
#pragma once

#include <cstdint>

namespace rbpa::app {

class ScaledInteger {
 public:
  ScaledInteger(double scale, double offset);

  double operator()(std::int32_t value) const {
    if (exact_) return static_cast<double>(value * factor_ + summand_) / divisor_;
    return static_cast<double>(value) * scale_ + offset_;
  }

 private:
  double scale_, offset_;
  bool exact_ = false;
  std::int64_t factor_ = 0, summand_ = 0;  // scale and offset times divisor_, a power of ten
  double divisor_ = 1;
};

}  // namespace rbpa::app
