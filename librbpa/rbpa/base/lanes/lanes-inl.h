// What: converts a vector's mask to the bits of an integer, and back; moves the lanes of a mask to the front; vectors
//       of space in the lanes of registers. Compiled once for each kind of vector unit; HWY_TARGET_TOGGLE is the
//       include guard.
#if defined(RBPA_BASE_LANES_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_BASE_LANES_LANES_INL_H_
#undef RBPA_BASE_LANES_LANES_INL_H_
#else
#define RBPA_BASE_LANES_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "rbpa/base/lanes/set_bits.h"

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

/// A permutation of at most eight 64-bit lanes, as with some compilers, Highway's Compress of 64-bit lanes copies a
/// table to the stack at each call: moves the lanes whose bits are set to the front, in their order. The other lanes of
/// the result are unspecified.
template <typename D>
class LanesToFront {
 public:
  HWY_INLINE LanesToFront(D d, std::uint64_t bits) : indices_(indices(d, bits)) {}

  HWY_INLINE hn::Vec<D> operator()(hn::Vec<D> v) const { return hn::TableLookupLanes(v, indices_); }

 private:
  static HWY_INLINE auto indices(D d, std::uint64_t bits) {
    const hn::RebindToSigned<D> numbers;
    const hn::Rebind<std::int32_t, D> halves;
    const hn::Rebind<std::uint8_t, D> bytes;
    const auto positions = hn::LoadU(bytes, set_bits[bits].data());
    return hn::IndicesFromVec(d, hn::PromoteTo(numbers, hn::PromoteTo(halves, positions)));
  }

  decltype(indices(D(), 0)) indices_;
};

/// Vectors of space in the lanes of registers.
template <typename V>
struct Vector3Lanes {
  V x, y, z;
};

template <typename V>
HWY_INLINE V dot(const Vector3Lanes<V>& u, const Vector3Lanes<V>& v) {
  return hn::MulAdd(u.x, v.x, hn::MulAdd(u.y, v.y, hn::Mul(u.z, v.z)));
}
template <typename V>
HWY_INLINE Vector3Lanes<V> cross(const Vector3Lanes<V>& u, const Vector3Lanes<V>& v) {
  const auto minor = [](V a, V b, V c, V e) HWY_ATTR { return hn::NegMulAdd(c, e, hn::Mul(a, b)); };
  return {minor(u.y, v.z, u.z, v.y), minor(u.z, v.x, u.x, v.z), minor(u.x, v.y, u.y, v.x)};
}

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
