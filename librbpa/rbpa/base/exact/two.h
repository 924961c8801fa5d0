// What: a pair of numbers with element-wise arithmetic; a pair of doubles takes one register.
// Why:  one instruction does the work of two. Compilers that pack scalars on their own do it so late that instructions
//       wait for the packed register.
#pragma once

#include <cmath>
#include <cstdint>

namespace rbpa {

template <typename Real>
struct TwoNumbers {
  Real at[2];

  Real operator[](int i) const { return at[i]; }
  friend TwoNumbers operator+(const TwoNumbers& v, const TwoNumbers& w) { return {v[0] + w[0], v[1] + w[1]}; }
  friend TwoNumbers operator-(const TwoNumbers& v, const TwoNumbers& w) { return {v[0] - w[0], v[1] - w[1]}; }
  friend TwoNumbers operator*(const TwoNumbers& v, const TwoNumbers& w) { return {v[0] * w[0], v[1] * w[1]}; }
};

template <typename Real>
struct TwoOf {
  using Type = TwoNumbers<Real>;
};
template <>
struct TwoOf<double> {
  using Type = double __attribute__((vector_size(16)));
};

/// A pair v[0], v[1] with element-wise sums, differences and products.
template <typename Real>
using Two = typename TwoOf<Real>::Type;

template <typename V>
V swapped(const V& v) {
  return V{v[1], v[0]};
}
template <typename V>
V firsts(const V& v, const V& w) {
  return V{v[0], w[0]};
}
template <typename V>
V seconds(const V& v, const V& w) {
  return V{v[1], w[1]};
}
template <typename V>
V magnitudes(const V& v) {
  return V{std::abs(v[0]), std::abs(v[1])};
}
inline Two<double> magnitudes(const Two<double>& v) {
  using Bits = std::int64_t __attribute__((vector_size(16)));
  const Two<double> signs = {-0.0, -0.0};
  return reinterpret_cast<Two<double>>(reinterpret_cast<Bits>(v) & ~reinterpret_cast<Bits>(signs));
}

}  // namespace rbpa
