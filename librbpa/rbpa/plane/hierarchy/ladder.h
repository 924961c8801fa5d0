// What:   the radii of the levels: 2^i α₀, then the last one; and the same radii in the scale of the window of doubles.
// Source: Restricted BPA, section 6.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/predicate/window.h"

namespace rbpa {

class Ladder {
 public:
  using Real = long double;             ///< its range holds the circumradii of all points with double coordinates
  static constexpr int never = 0xffff;  ///< above all levels

  /// Builds the radii from `least` to `last`. If `last` is infinite, only the last level may have a radius above
  /// `largest`.
  /// Requires: 0 < least < ∞.
  Ladder(double least, Radius last, Real largest) : least_(least), last_(last) {
    const Real bound =
        last.is_infinite() ? std::min(largest, Real(std::numeric_limits<double>::max())) : Real(last.value());
    while (std::ldexp(Real(least), end_) < bound) ++end_;
  }

  double least() const { return least_; }
  /// Returns the number of the last level, that of the radius `last`.
  int end() const { return end_; }
  bool is_last(int level) const { return level >= end_; }
  Radius radius(int level) const { return is_last(level) ? last_ : Radius(std::ldexp(least_, level)); }

  /// Returns the first level whose radius is at least `radius`, or, seldom, the level before it, but never a later
  /// level; `radius` may therefore be rounded. The result may be above end() if a finite last radius is less than
  /// `radius`.
  int first_reaching(Real radius) const {
    constexpr Real deflated = 1 - Real(1e-5);
    const Real ratio = radius / Real(least_) * deflated;
    if (!(ratio > 1)) return 0;
    if (!(ratio < std::numeric_limits<Real>::infinity())) return never;
    const int exponent = exponent_of(ratio);
    return last_.is_infinite() ? std::min(exponent, end_) : exponent;
  }

 private:
  /// Returns the exponent of `ratio` as frexp() does, or one more where rounding to double carries. Takes two
  /// instructions if the ratio is in the range of double.
  static int exponent_of(Real ratio) {
    int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(static_cast<double>(ratio)) >> 52) - 1022;
    if (!(ratio < Real(0x1p1000))) std::frexp(ratio, &exponent);
    return exponent;
  }

  double least_;
  Radius last_;
  int end_ = 0;
};

/// The radii of a ladder in the scale of a window.
class ScaledLadder {
 public:
  /// Keeps a reference to the ladder. Cost: linear in the levels.
  ScaledLadder(const Ladder& ladder, const Window& window)
      : ladder_(ladder), per_scaled_(std::ldexp(Ladder::Real(1), -window.exponent)) {
    for (int level = 0; level <= ladder.end(); ++level) radii_.push_back(window.scaled(ladder.radius(level)));
  }

  int end() const { return ladder_.end(); }
  bool is_last(int level) const { return ladder_.is_last(level); }
  const Radius& radius(int level) const { return radii_[static_cast<std::size_t>(level)]; }
  /// Returns Ladder::first_reaching() of a radius in the scale of the window.
  int first_reaching(double radius) const { return ladder_.first_reaching(radius * per_scaled_); }

 private:
  const Ladder& ladder_;
  Ladder::Real per_scaled_;
  std::vector<Radius> radii_;
};

}  // namespace rbpa
