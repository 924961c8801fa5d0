// What: prepares the sphere through four points for the most frequent test, whether another point is inside.
// How:  stores the minors of the first three rows of the in-sphere determinant; four products remain for a point q:
//
//                  | a − d   |a − d|² |
//           V(q) = | b − d   |b − d|² |  =  minor · (q − d, |q − d|²)
//                  | c − d   |c − d|² |
//                  | q − d   |q − d|² |      positive inside if (b − a) × (c − a) · (d − a) > 0
//
//       A corner may be at infinity. Its row is (0, 0, 0, 1), the limit of a far corner's row divided by the corner's
//       lift: the sphere is the half-space beyond the plane through the other corners, and V has four products, too.
//       Points may be balls, whose weights are their squared radii: the weight of the point minus that of d is
//       subtracted from the square in each row.
// Law:  |computed V − V| ≤ error; docs/explanation/exact_decisions.md, section 7, derives the bound of the error.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace rbpa::space {

/// The vector from corner d to another corner, with its squared length and its length. A length below 2^−200 is stored
/// as 2^−200: its square may underflow, and error bounds need a number that is not below the length. Lengths are at
/// least 2^−150 unless coordinates were rounded (spread.h).
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

/// A spoke from ball to ball. `square` is the squared length minus the difference of weights; `reach_` is the squared
/// length plus the absolute difference, divided by the length.
struct WeightedSpoke : Spoke {
  double reach_;

  static WeightedSpoke to(double x, double y, double z, double weight) {
    const Spoke spoke = Spoke::to(x, y, z);
    return {{x, y, z, spoke.square - weight, spoke.length}, (spoke.square + std::abs(weight)) / spoke.length};
  }
  static WeightedSpoke to_infinity() { return {Spoke::to_infinity(), 0}; }
  double reach() const { return reach_; }
};

/// Returns R² − S², the difference of the weights of two balls, with three roundings.
inline double weight_difference(double R, double S) { return (R - S) * (R + S); }

/// A bound for the error of V(q): constant + slope · |q − d|² for points, constant + slope · (|q − d|² + |difference of
/// weights|) for balls. The two doubles are rounded up and stored by their first 32 bits.
class ErrorBound {
 public:
  ErrorBound() = default;
  ErrorBound(double constant, double slope)
      : bits_(((std::bit_cast<std::uint64_t>(constant) >> 32U) + 1) |
              ((std::bit_cast<std::uint64_t>(slope) & high_bits) + low_one)) {}

  /// Returns the mark of a deleted tetrahedron that has no bound.
  static ErrorBound deleted() {
    ErrorBound bound;
    bound.bits_ = ~std::uint64_t{0};
    return bound;
  }
  /// Returns the bound with the mark of a deleted tetrahedron, or a marked bound without the mark; if not `is_meant`,
  /// the bound itself. A marked bound is negative or NaN.
  ErrorBound marked_if(bool is_meant) const {
    ErrorBound bound;
    bound.bits_ = bits_ ^ -std::uint64_t{is_meant};
    return bound;
  }
  bool is_deleted() const { return bits_ >> 63U != 0; }

  double constant() const { return std::bit_cast<double>(bits_ << 32U); }
  double slope() const { return std::bit_cast<double>(bits_ & high_bits); }
  double at(double square) const { return constant() + slope() * square; }

 private:
  static constexpr std::uint64_t low_one = std::uint64_t{1} << 32U, high_bits = ~(low_one - 1);
  std::uint64_t bits_;
};

/// The factors of the four products of V(q): of x, y, z and |q − d|².
using SphereMinors = std::array<double, 4>;

/// Returns the minors of the sphere through d and the ends of the spokes from d to a, b and c.
inline SphereMinors sphere_minors(const Spoke& a, const Spoke& b, const Spoke& c) {
  const double xy = b.x * c.y - b.y * c.x, yz = b.y * c.z - b.z * c.y, xz = b.x * c.z - b.z * c.x,
               xs = b.x * c.square - b.square * c.x, ys = b.y * c.square - b.square * c.y,
               zs = b.z * c.square - b.square * c.z;
  return {-(a.y * zs - a.z * ys + a.square * yz), a.x * zs - a.z * xs + a.square * xz,
          -(a.x * ys - a.y * xs + a.square * xy), a.x * yz - a.y * xz + a.z * xy};
}

/// Constant of the filter: errors are below this constant times the lengths in docs/explanation/exact_decisions.md,
/// sections 7 and 8. It covers the error of V, below 20 · 2^−53 for points and 21 · 2^−53 with weights, and the
/// roundings of the bound.
inline constexpr double in_sphere_filter = 24 * 0x1p-53;

/// Returns the bound of the error of V with the minors of sphere_minors(a, b, c). Requires: no corner at infinity;
/// `underflow` is Spread::underflow().
template <typename AnySpoke>
ErrorBound sphere_error(const AnySpoke& a, const AnySpoke& b, const AnySpoke& c, double underflow) {
  const double sum = a.reach() + b.reach() + c.reach(), weight = in_sphere_filter * (a.length * b.length * c.length);
  return {0.5 * weight * sum * sum + underflow, 1.5 * weight};
}

/// Returns the bound of the error of V if one corner is at infinity. Requires: one spoke is Spoke::to_infinity(), of
/// length 0; `underflow` is Spread::underflow().
inline ErrorBound half_space_error(const Spoke& a, const Spoke& b, const Spoke& c, double underflow) {
  const double sum = a.length + b.length + c.length;
  // The second largest length is not computed as sum − first, which would be rounded to 0 for a much shorter length.
  const double first = std::max({a.length, b.length, c.length}),
               second =
                   std::max({std::min(a.length, b.length), std::min(b.length, c.length), std::min(c.length, a.length)});
  const double weight = in_sphere_filter * (first * second / sum);
  return {0.5 * weight * sum * sum + underflow, 1.5 * weight};
}

/// The comparison of a sphere's radius with alpha.
enum class RadiusSide { within, beyond, unknown };

/// Returns the comparison of the radius with alpha by the minors, or `unknown` where it is not certain
/// (docs/explanation/exact_decisions.md, section 7).
inline RadiusSide radius_side(const SphereMinors& m, const ErrorBound& error, double alpha) {
  // (m0, m1, m2) is −2 m3 times the vector from d to the circumcenter.
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
