// What: moves chosen lanes of several vectors to the front. Compiled once for each kind of
//       vector unit; HWY_TARGET_TOGGLE is the include guard.
// Why:  with some compilers, Highway's Compress of 64-bit lanes copies a table to the stack at each call.
#if defined(RBPA_BASE_LANES_COMPRESS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_BASE_LANES_COMPRESS_INL_H_
#undef RBPA_BASE_LANES_COMPRESS_INL_H_
#else
#define RBPA_BASE_LANES_COMPRESS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "rbpa/base/lanes/mask_bits-inl.h"
#include "rbpa/base/lanes/set_bits.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

/// A permutation of at most eight 64-bit lanes: moves the lanes whose bits are set to the front, in their order. The
/// other lanes of the result are unspecified.
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

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
