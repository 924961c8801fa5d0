// What:   exact sums and products of doubles, as sums of doubles that do not overlap.
// Law:    exact as long as no product underflows or overflows: see fits_double() in magnitude.h.
// Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates (1997).
#pragma once

#include <array>
#include <cmath>

namespace rbpa {

/// A sum of `size` nonzero doubles, the smallest first, whose bits do not overlap. The sum zero has no component.
template <int Capacity>
struct Expansion {
  std::array<double, static_cast<unsigned>(Capacity)> component;
  int size = 0;

  void append(double c) {
    if (c != 0) component[static_cast<unsigned>(size++)] = c;
  }
  int sign() const {
    if (size == 0) return 0;
    return component[static_cast<unsigned>(size - 1)] > 0 ? 1 : -1;  // the largest outweighs all others
  }
};

namespace detail {

struct TwoTerms {
  double high, low;
};

inline TwoTerms two_sum(double a, double b) {
  const double sum = a + b;
  const double b_virtual = sum - a, a_virtual = sum - b_virtual;
  return {sum, (a - a_virtual) + (b - b_virtual)};
}

inline TwoTerms split(double a) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1: halves a 53-bit significand
  const double c = splitter * a;
  const double high = c - (c - a);
  return {high, a - high};
}

inline TwoTerms two_product(double a, double b) {
  const double product = a * b;
  const TwoTerms x = split(a), y = split(b);
  const double error = ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low;
  return {product, error};
}

}  // namespace detail

/// Returns a − b, exactly.
inline Expansion<2> difference(double a, double b) {
  const auto [high, low] = detail::two_sum(a, -b);
  Expansion<2> result;
  result.append(low);
  result.append(high);
  return result;
}

template <int N>
Expansion<N> operator-(const Expansion<N>& e) {
  Expansion<N> result;  // only the components in use are written
  for (int i = 0; i < e.size; ++i) result.append(-e.component[static_cast<unsigned>(i)]);
  return result;
}

/// Returns e + f, exactly (Shewchuk, fast expansion sum with zero elimination). Adds the components in order of size.
template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> result;
  int i = 0, j = 0;
  const auto take = [&] {
    const bool from_e = j >= f.size || (i < e.size && std::abs(e.component[static_cast<unsigned>(i)]) <
                                                          std::abs(f.component[static_cast<unsigned>(j)]));
    return from_e ? e.component[static_cast<unsigned>(i++)] : f.component[static_cast<unsigned>(j++)];
  };
  if (e.size + f.size == 0) return result;
  double carry = take();
  while (i < e.size || j < f.size) {
    const auto [high, low] = detail::two_sum(carry, take());
    result.append(low);
    carry = high;
  }
  result.append(carry);
  return result;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& e, const Expansion<M>& f) {
  return e + (-f);
}

/// Returns e · b, exactly (Shewchuk, scale expansion with zero elimination).
template <int N>
Expansion<2 * N> operator*(const Expansion<N>& e, double b) {
  Expansion<2 * N> result;
  if (e.size == 0) return result;
  auto [carry, error] = detail::two_product(e.component[0], b);
  result.append(error);
  for (int i = 1; i < e.size; ++i) {
    const auto [high, low] = detail::two_product(e.component[static_cast<unsigned>(i)], b);
    const auto first = detail::two_sum(carry, low);
    result.append(first.low);
    const auto second = detail::two_sum(high, first.high);
    result.append(second.low);
    carry = second.high;
  }
  result.append(carry);
  return result;
}

template <int N, int M>
Expansion<2 * N * M> operator*(const Expansion<N>& e, const Expansion<M>& f) {
  // The sum has one scaled copy of e for each component of f. Differences of nearby coordinates mostly have one
  // component, so the copies are few.
  Expansion<2 * N * M> result;
  for (int j = 0; j < f.size; ++j) {
    const auto sum = result + e * f.component[static_cast<unsigned>(j)];
    result.size = sum.size;
    for (int i = 0; i < sum.size; ++i)
      result.component[static_cast<unsigned>(i)] = sum.component[static_cast<unsigned>(i)];
  }
  return result;
}

}  // namespace rbpa
