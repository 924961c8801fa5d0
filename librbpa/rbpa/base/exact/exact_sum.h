// What: sums of products of doubles without any error until the end.
// How:  one number of fixed point, wide enough for the product of any two doubles, in digits of 32 bits whose carries
//       wait. Source: Kulisch, Miranker, Computer Arithmetic in Theory and Practice (1981).
// Law:  the sum does not depend on the order.
// Cost: some nanoseconds a product; 1 KiB.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rbpa {

class ExactSum {
 public:
  /// Requires: finite.
  void add(double value);
  void add_product(double a, double b);

  ExactSum& operator+=(const ExactSum& other);

  /// Digit i counts 2^(32 i) times a unit that never changes; all but the last are in [0, 2³²), the last has the sign.
  using Digits = std::array<std::int64_t, 142>;
  /// A function of the sum alone.
  Digits digits() const;
  /// Requires: digits as above.
  static ExactSum of(const Digits& digits);

  /// The double nearest to the sum times 2^exponent (next to nearest where that is subnormal); infinity beyond the
  /// largest.
  double rounded(int exponent = 0) const;

 private:
  static void carry(Digits& digits);
  void touch(unsigned first_position, unsigned last_position);
  void add_bits(std::uint64_t bits, unsigned position, bool negative);
  void added();

  Digits digits_{};  // digit i counts 2^(32 i − offset); between carries any integer
  std::size_t begin_ = std::tuple_size_v<Digits>, end_ = 0;  // all others are 0
  std::uint32_t additions_ = 0;
};

}  // namespace rbpa
