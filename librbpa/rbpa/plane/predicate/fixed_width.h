// What: differences of points as integers of a fixed width, times a power of two. Differences have this form on grids,
//       and wherever coordinates have few bits.
// Law:  exact: an expression that is homogeneous in the differences keeps its sign.
// Why:  on grids nearly every circle is a tie, which no filter decides; integers decide a tie in the time of two
//       filters.
// Cost: some nanoseconds, and less if the differences do not fit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rbpa/base/exact/expansion.h"
#include "rbpa/base/exact/integer128.h"
#include "rbpa/base/point.h"

namespace rbpa {

struct FixedVector {
  std::int64_t x = 0, y = 0;
  FixedVector operator-(const FixedVector& v) const { return {x - v.x, y - v.y}; }
  std::int64_t dot(const FixedVector& v) const { return x * v.x + y * v.y; }
  std::int64_t cross(const FixedVector& v) const { return x * v.y - y * v.x; }
};

/// The vectors from one point to N others, as integers times a common power of two.
template <std::size_t N>
class FixedVectors {
 public:
  /// Computes the vectors from `from` to each point of `to`, with integers below 2^bits in absolute value. Requires:
  /// points that fit double (base/exact/magnitude.h).
  FixedVectors(int bits, const Point& from, const std::array<const Point*, N>& to) {
    std::array<double, 2 * N> difference;
    double greatest = 0;
    for (std::size_t i = 0; i < 2 * N; ++i) {
      const double a = i % 2 == 0 ? from.x : from.y, b = i % 2 == 0 ? to[i / 2]->x : to[i / 2]->y;
      const detail::TwoTerms sum = detail::two_sum(b, -a);
      if (sum.low != 0) return;
      difference[i] = sum.high;
      greatest = std::max(greatest, std::abs(sum.high));
    }
    if (greatest == 0) greatest = 1;
    // Brings the greatest difference below 2^bits.
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(greatest) >> 52;
    const double scale = std::bit_cast<double>((2046 + static_cast<std::uint64_t>(bits) - 1 - exponent) << 52);
    for (std::size_t i = 0; i < 2 * N; ++i) {
      const double scaled = difference[i] * scale;
      const auto whole = static_cast<std::int64_t>(scaled);
      if (static_cast<double>(whole) != scaled) return;
      (i % 2 == 0 ? vector_[i / 2].x : vector_[i / 2].y) = whole;
    }
    are_exact_ = true;
  }

  /// Returns whether integers below 2^bits in absolute value suffice. Otherwise the vectors are unspecified.
  bool are_exact() const { return are_exact_; }
  const FixedVector& operator[](std::size_t i) const { return vector_[i]; }

 private:
  std::array<FixedVector, N> vector_;
  bool are_exact_ = false;
};

}  // namespace rbpa
