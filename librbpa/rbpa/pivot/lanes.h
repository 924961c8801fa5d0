// What: several numbers computed side by side, in the compiler's vector types, without a branch.
// Why:  written as a loop, selections become branches that cannot be predicted.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rbpa {

/// One lane: for types that processors have no vectors of.
template <typename Real>
struct Lanes {
  static constexpr std::size_t width = 1;
  using Value = Real;
  using Mask = std::int64_t;  ///< 0 or −1
  static Value load(const Real* from) { return *from; }
  static void store(Real* to, Value v) { *to = v; }
  static Value all(Real r) { return r; }
  static Value size(Value v) { return v < 0 ? -v : v; }
  static Mask less_equal(Value a, Value b) { return -static_cast<Mask>(a <= b); }
  static Value select(Mask condition, Value yes, Value no) { return condition ? yes : no; }
  static Mask select_mask(Mask condition, Mask yes, Mask no) { return condition ? yes : no; }
  static Real least(Value v) { return v; }
  static std::int64_t sum(Mask m) { return m; }
  static std::int64_t greatest(Mask m) { return m; }
  static Mask positions() { return 0; }
};

template <>
struct Lanes<double> {
  static constexpr std::size_t width = 2;  // what every 64-bit processor has
  using Value = double __attribute__((vector_size(16)));
  using Mask = std::int64_t __attribute__((vector_size(16)));
  static Value load(const double* from) { return Value{from[0], from[1]}; }
  static void store(double* to, Value v) {
    to[0] = v[0];
    to[1] = v[1];
  }
  static Value all(double r) { return Value{r, r}; }
  /// Absolute value: clears the sign bit.
  static Value size(Value v) { return reinterpret_cast<Value>(reinterpret_cast<Mask>(v) & ~(Mask{1, 1} << 63)); }
  static Mask less_equal(Value a, Value b) { return a <= b; }
  static Value select(Mask condition, Value yes, Value no) { return condition ? yes : no; }
  static Mask select_mask(Mask condition, Mask yes, Mask no) { return condition ? yes : no; }
  static double least(Value v) { return v[0] < v[1] ? v[0] : v[1]; }
  static std::int64_t sum(Mask m) { return m[0] + m[1]; }
  static std::int64_t greatest(Mask m) { return m[0] > m[1] ? m[0] : m[1]; }
  static Mask positions() { return Mask{0, 1}; }
};

}  // namespace rbpa
