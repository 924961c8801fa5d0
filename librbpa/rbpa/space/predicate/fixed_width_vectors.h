// What: represents differences of points in space as integers below 2^61 times a power of two, and computes signs of
//       their determinants in words of 64 bits. Differences have this form on any grid, and for most points near each
//       other.
// Law:  exact: the power of two does not change the sign of an expression that is homogeneous in the differences.
// Why:  most in-sphere tests on grids are ties, which no filter decides.
// Cost: a tenth of a microsecond, a twentieth of that of integers of any length; nanoseconds if differences do not fit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rbpa/base/exact/expansion.h"
#include "rbpa/base/exact/integer128.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

using FixedVector = Vector3<std::int64_t>;  // components are below 2^61 in absolute value

/// Returns the sign of u × v · w.
int volume_sign(const FixedVector& u, const FixedVector& v, const FixedVector& w);

/// Returns the sign of (volume of u, v, w) · (power of p to the sphere through 0, u, v, w). Weights, if given, are
/// subtracted from the squares of u, v, w and p, in this order. Requires: weights are below 2^122 in absolute value.
int power_sign(const FixedVector& u, const FixedVector& v, const FixedVector& w, const FixedVector& p);
int power_sign(const FixedVector& u, const FixedVector& v, const FixedVector& w, const FixedVector& p,
               const std::array<Integer128, 4>& weights);

/// Vectors from one point to N others. If the points are weighted, also the weight of each other point minus that of
/// the first point; the first of `radii` is that of the first point. Requires: finite points and radii; `radii` are
/// given if and only if `weighted`.
template <std::size_t N, bool weighted = false>
class FixedVectors {
 public:
  FixedVectors(const Point3& from, const std::array<const Point3*, N>& to,
               [[maybe_unused]] const std::array<double, N + 1>* radii = nullptr) {
    std::uint64_t unit = 2047;  // 1075 + the exponent of the lowest set bit of all values
    bool are_normal = true;
    const auto include = [&](double value) {
      const std::uint64_t bits = std::bit_cast<std::uint64_t>(value) & ~(std::uint64_t{1} << 63U);
      const std::uint64_t exponent = bits >> 52U;
      const auto zeros = static_cast<std::uint64_t>(std::countr_zero(bits | std::uint64_t{1} << 52U));
      if (bits != 0) unit = std::min(unit, exponent + zeros);
      are_normal &= bits == 0 || exponent != 0;
    };
    for (const double value : {from.x, from.y, from.z}) include(value);
    for (const Point3* p : to)
      for (const double value : {p->x, p->y, p->z}) include(value);
    if constexpr (weighted)
      for (const double radius : *radii) include(radius);
    if (!are_normal || unit < 1075 - 1022) return;
    const double scale = std::bit_cast<double>((1023 + 1075 - unit) << 52U);
    const auto whole = [&](double a, double b) {
      const rbpa::detail::TwoTerms sum = rbpa::detail::two_sum(b, -a);
      const double high = sum.high * scale;
      if (!(std::abs(high) < 0x1p60)) {
        are_exact_ = false;
        return std::int64_t{0};
      }
      return static_cast<std::int64_t>(high) + static_cast<std::int64_t>(sum.low * scale);
    };
    are_exact_ = true;
    for (std::size_t i = 0; i < N; ++i)
      vector_[i] = {whole(from.x, to[i]->x), whole(from.y, to[i]->y), whole(from.z, to[i]->z)};
    if constexpr (weighted)
      for (std::size_t i = 0; i < N; ++i) {
        const double own = (*radii)[i + 1], first = (*radii)[0];
        weight_[i] = Integer128{whole(first, own)} * whole(-first, own);
      }
  }

  /// Returns whether the vectors are represented exactly. If not, vectors and weights are unspecified.
  bool are_exact() const { return are_exact_; }
  const FixedVector& operator[](std::size_t i) const { return vector_[i]; }
  const std::array<Integer128, N>& weights() const requires weighted { return weight_; }

 private:
  std::array<FixedVector, N> vector_;
  std::array<Integer128, weighted ? N : 0> weight_;
  bool are_exact_ = false;
};

}  // namespace rbpa::space
