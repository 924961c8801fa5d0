// What: converts a vector's mask to the bits of an integer, and back. Compiled once for each kind of
//       vector unit; HWY_TARGET_TOGGLE is the include guard.
#if defined(RBPA_BASE_LANES_MASK_BITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_BASE_LANES_MASK_BITS_INL_H_
#undef RBPA_BASE_LANES_MASK_BITS_INL_H_
#else
#define RBPA_BASE_LANES_MASK_BITS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// The integer type that holds a stored mask. A read as wide as the store avoids a store-forwarding stall.
template <typename D>
using MaskBits = std::conditional_t<hn::MaxLanes(D()) == 16, std::uint16_t, std::uint8_t>;

/// Returns the mask as bits: bit i is set if lane i is set. Requires: at most 16 lanes.
template <typename D>
HWY_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8];  // StoreMaskBits may write all eight
  hn::StoreMaskBits(d, mask, bytes);
  MaskBits<D> bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

/// Returns the mask in which lane i is set if bit i is set; further bits are ignored. Requires: at most 16 lanes.
template <typename D>
HWY_INLINE hn::Mask<D> mask_of(D d, std::uint64_t all) {
  std::uint8_t bytes[8];  // LoadMaskBits may read all eight
  std::memcpy(bytes, &all, sizeof bytes);
  return hn::LoadMaskBits(d, bytes);
}

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
