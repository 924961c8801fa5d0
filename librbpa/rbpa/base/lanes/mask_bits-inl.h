// What: a vector's mask as bits of a number, and back. Compiled once for each kind of vector unit; no include guard but
//       the compiler's own per kind.
#if defined(RBPA_VECTOR_MASK_BITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_VECTOR_MASK_BITS_INL_H_
#undef RBPA_VECTOR_MASK_BITS_INL_H_
#else
#define RBPA_VECTOR_MASK_BITS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace rbpa {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// As wide as it is written and read: what is read at once must have been written at once, or it waits.
template <typename D>
using MaskBits = std::conditional_t<hn::MaxLanes(D()) == 16, std::uint16_t, std::uint8_t>;

/// Bit i is that of lane i. Requires at most 16 lanes.
template <typename D>
HWY_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8];  // as many as may be written
  hn::StoreMaskBits(d, mask, bytes);
  MaskBits<D> bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

template <typename D>
HWY_INLINE hn::Mask<D> mask_of(D d, std::uint64_t all) {
  std::uint8_t bytes[8];  // as many as may be read
  std::memcpy(bytes, &all, sizeof bytes);
  return hn::LoadMaskBits(d, bytes);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace rbpa
HWY_AFTER_NAMESPACE();

#endif
