// What: the sphere through four points, prepared for the most frequent test: is another point inside?
// How:  stores the minors of the first three rows of the in-sphere determinant; four products remain for a point q:
//
//                  | a − d   |a − d|² |
//           V(q) = | b − d   |b − d|² |  =  minor · (q − d, |q − d|²)   positive inside: a, b, c, d positively oriented
//                  | c − d   |c − d|² |
//                  | q − d   |q − d|² |
//
//       A corner may be at infinity. Its row is (0, 0, 0, 1), the limit of a far corner's row divided by its lift: the
//       sphere is the half-space beyond the plane through the others, and V is the same four products. Points may be
//       balls, which have a weight, the square of their radius: of each row's square the difference of the weights of
//       the point and of d is subtracted.
// Law:  |V computed − V| ≤ error; docs/explanation/exact_decisions.md, section 7, derives the filter's bound.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace rbpa::space {

/// A corner relative to corner d, with its squared length and its length. A length below 2^−200 counts as 2^−200: its
/// square may underflow, and error bounds need no less than the length. Lengths are at least 2^−150 unless coordinates
/// were rounded (spread.h).
struct Spoke {
  double x, y, z, square, length;

  static Spoke to(double x, double y, double z) {
    const double square = x * x + y * y + z * z;
    return {x, y, z, square, std::max(std::sqrt(square), 0x1p-200)};
  }
  static Spoke to_infinity() { return {0, 0, 0, 1, 0}; }
  /// Returns the length that stands for the square in error bounds.
  double reach() const { return length; }
};

/// A spoke from ball to ball: its square is less the difference of the weights, its reach the sum of both by absolute
/// value, divided by the length.
struct WeightedSpoke : Spoke {
  double reach_;

  static WeightedSpoke to(double x, double y, double z, double weight) {
    const Spoke spoke = Spoke::to(x, y, z);
    return {{x, y, z, spoke.square - weight, spoke.length}, (spoke.square + std::abs(weight)) / spoke.length};
  }
  static WeightedSpoke to_infinity() { return {Spoke::to_infinity(), 0}; }
  double reach() const { return reach_; }
};

/// Returns the difference of the weights of two balls, R² − S², with three roundings.
inline double weight_difference(double R, double S) { return (R - S) * (R + S); }

/// A bound for the error of V(q): constant + slope |q − d|², or with the difference of weights by absolute value in
/// place of 0: constant + slope (|q − d|² + |difference|). Stored as the first 32 bits of two doubles, rounded up.
class ErrorBound {
 public:
  ErrorBound() = default;
  ErrorBound(double constant, double slope)
      : bits_(((std::bit_cast<std::uint64_t>(constant) >> 32U) + 1) |
              ((std::bit_cast<std::uint64_t>(slope) & high_bits) + low_one)) {}

  /// Returns the mark of a deleted tetrahedron: NaN, so that no comparison with it is true.
  static ErrorBound deleted() {
    ErrorBound bound;
    bound.bits_ = ~std::uint64_t{0};
    return bound;
  }
  ErrorBound deleted_if(bool is_meant) const {
    ErrorBound bound;
    bound.bits_ = bits_ | -std::uint64_t{is_meant};
    return bound;
  }
  bool is_deleted() const { return bits_ == ~std::uint64_t{0}; }

  double constant() const { return std::bit_cast<double>(bits_ << 32U); }
  double slope() const { return std::bit_cast<double>(bits_ & high_bits); }
  double at(double square) const { return constant() + slope() * square; }

 private:
  static constexpr std::uint64_t low_one = std::uint64_t{1} << 32U, high_bits = ~(low_one - 1);
  std::uint64_t bits_;
};

/// The factors of the four products of V(q): of x, y, z and |q − d|².
using SphereMinors = std::array<double, 4>;

inline SphereMinors sphere_minors(const Spoke& a, const Spoke& b, const Spoke& c) {
  const double xy = b.x * c.y - b.y * c.x, yz = b.y * c.z - b.z * c.y, xz = b.x * c.z - b.z * c.x,
               xs = b.x * c.square - b.square * c.x, ys = b.y * c.square - b.square * c.y,
               zs = b.z * c.square - b.square * c.z;
  return {-(a.y * zs - a.z * ys + a.square * yz), a.x * zs - a.z * xs + a.square * xz,
          -(a.x * ys - a.y * xs + a.square * xy), a.x * yz - a.y * xz + a.z * xy};
}

/// Filter constant: errors are below this times the lengths of docs/explanation/exact_decisions.md, section 7. It
/// covers 20 roundings there, and some of the bound itself; 18 with weights are less than 21.
inline constexpr double in_sphere_filter = 24 * 0x1p-53;

/// Returns the error bound of V by sphere_minors(a, b, c). Requires: no corner at infinity; `underflow` is
/// Spread::underflow().
template <typename AnySpoke>
ErrorBound sphere_error(const AnySpoke& a, const AnySpoke& b, const AnySpoke& c, double underflow) {
  const double sum = a.reach() + b.reach() + c.reach(), weight = in_sphere_filter * (a.length * b.length * c.length);
  return {0.5 * weight * sum * sum + underflow, 1.5 * weight};
}

/// Returns the same bound if one corner is at infinity. Requires: its spoke is Spoke::to_infinity(), of length 0.
inline ErrorBound half_space_error(const Spoke& a, const Spoke& b, const Spoke& c, double underflow) {
  const double sum = a.length + b.length + c.length;
  // The second largest length by itself: a difference from the sum is rounded to 0 where it is that much shorter.
  const double first = std::max({a.length, b.length, c.length}),
               second =
                   std::max({std::min(a.length, b.length), std::min(b.length, c.length), std::min(c.length, a.length)});
  const double weight = in_sphere_filter * (first * second / sum);
  return {0.5 * weight * sum * sum + underflow, 1.5 * weight};
}

/// The comparison of a sphere's radius with alpha.
enum class RadiusSide { within, beyond, unknown };

/// Compares the radius with alpha by the minors, where nothing underflows; docs/explanation/exact_decisions.md, section
/// 7.
inline RadiusSide radius_side(const SphereMinors& m, const ErrorBound& error, double alpha) {
  // (m0, m1, m2) is 2 minor 3 times the vector to the circumcenter.
  constexpr double up = 1 + 0x1p-48, down = 1 - 0x1p-48;
  const double volume = std::abs(m[3]), volume_error = error.slope();
  const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]),
               length_error = 1.25 * std::sqrt(error.constant()) * std::sqrt(volume_error);
  if (!(alpha > 0x1p-200 && length > 0x1p-450 && std::isfinite(length))) return RadiusSide::unknown;
  const double greatest_length = (length + length_error) * up, least_length = (length - length_error) * down;
  const double greatest = 2 * alpha * (volume + volume_error) * up + 0x1p-1000,
               least = 2 * alpha * (volume - volume_error) * down;
  if (greatest_length <= least) return RadiusSide::within;
  return least_length > greatest ? RadiusSide::beyond : RadiusSide::unknown;
}

}  // namespace rbpa::space
