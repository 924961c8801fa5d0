// What:   double-double in the lanes of registers: the arithmetic of base/exact/double_double.h, with its error bounds,
//         on several numbers at a time. Compiled once for each kind of vector unit; HWY_TARGET_TOGGLE is the include
//         guard.
// Source: Dekker, A floating-point technique for extending the available precision (1971).
#if defined(RBPA_BASE_LANES_DOUBLE_DOUBLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_BASE_LANES_DOUBLE_DOUBLE_INL_H_
#undef RBPA_BASE_LANES_DOUBLE_DOUBLE_INL_H_
#else
#define RBPA_BASE_LANES_DOUBLE_DOUBLE_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

/// The numbers high + low, with |low| ≤ u |high| in each lane, where u = 2⁻⁵³.
template <typename D>
struct DoubleDoubleLanes {
  using V = hwy::HWY_NAMESPACE::Vec<D>;
  V high, low;

  static HWY_INLINE DoubleDoubleLanes sum_of(V a, V b) {
    namespace hn = hwy::HWY_NAMESPACE;
    const V sum = hn::Add(a, b), b_virtual = hn::Sub(sum, a), a_virtual = hn::Sub(sum, b_virtual);
    return {sum, hn::Add(hn::Sub(a, a_virtual), hn::Sub(b, b_virtual))};
  }
  static HWY_INLINE DoubleDoubleLanes difference(V a, V b) { return sum_of(a, hwy::HWY_NAMESPACE::Neg(b)); }
  static HWY_INLINE DoubleDoubleLanes product_of(V a, V b) {
    namespace hn = hwy::HWY_NAMESPACE;
    const V product = hn::Mul(a, b);
    // Without fused multiply-add, each factor is split into a high and a low half.
    constexpr bool is_fused = (HWY_TARGET & (HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL | HWY_NEON)) != 0;
    if constexpr (is_fused) return {product, hn::MulSub(a, b, product)};
    const auto half = [](V x) HWY_ATTR {
      const V scaled = hn::Mul(hn::Set(D(), 0x1p27 + 1), x);
      return hn::Sub(scaled, hn::Sub(scaled, x));
    };
    const V a_high = half(a), a_low = hn::Sub(a, a_high), b_high = half(b), b_low = hn::Sub(b, b_high);
    const V rest = hn::Sub(product, hn::Mul(a_high, b_high));
    const V next = hn::Sub(hn::Sub(rest, hn::Mul(a_low, b_high)), hn::Mul(a_high, b_low));
    return {product, hn::Sub(hn::Mul(a_low, b_low), next)};
  }

  friend HWY_INLINE DoubleDoubleLanes operator+(const DoubleDoubleLanes& a, const DoubleDoubleLanes& b) {
    namespace hn = hwy::HWY_NAMESPACE;
    const DoubleDoubleLanes sum = sum_of(a.high, b.high);
    return sum_of(sum.high, hn::Add(sum.low, hn::Add(a.low, b.low)));
  }
  friend HWY_INLINE DoubleDoubleLanes operator-(const DoubleDoubleLanes& a, const DoubleDoubleLanes& b) {
    namespace hn = hwy::HWY_NAMESPACE;
    return a + DoubleDoubleLanes{hn::Neg(b.high), hn::Neg(b.low)};
  }
  friend HWY_INLINE DoubleDoubleLanes operator*(const DoubleDoubleLanes& a, const DoubleDoubleLanes& b) {
    namespace hn = hwy::HWY_NAMESPACE;
    const DoubleDoubleLanes product = product_of(a.high, b.high);
    const V rest = hn::Add(product.low, hn::Add(hn::Mul(a.high, b.low), hn::Mul(a.low, b.high)));
    const V sum = hn::Add(product.high, rest);
    return {sum, hn::Sub(rest, hn::Sub(sum, product.high))};
  }
};

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
