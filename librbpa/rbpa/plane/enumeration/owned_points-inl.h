// What: the points that a tile owns, as bits by number and as labels, and their box. Compiled once for each kind of
//       vector unit; HWY_TARGET_TOGGLE is the include guard.
#if defined(RBPA_ENUMERATION_OWNED_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_ENUMERATION_OWNED_POINTS_INL_H_
#undef RBPA_ENUMERATION_OWNED_POINTS_INL_H_
#else
#define RBPA_ENUMERATION_OWNED_POINTS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/plane/enumeration/find_by_enumeration.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class OwnedPoints {
 public:
  using Bits = std::uint64_t;
  struct Box {
    float x_low, x_high, y_low, y_high;
  };
  static constexpr std::size_t word = 64;     ///< bits of a word
  static constexpr std::size_t padding = 16;  ///< labels after the last point, as a whole register is read

  explicit OwnedPoints(EnumerationWorkspace& own) : labels_(own.labels), bits_(own.owned_bits) {}

  /// Finds the points that the tile owns. Requires: `at` are the coordinates of `tile`; fewer than 2³⁰ points.
  void find(const Tile& tile, const TileCoordinates& at) {
    const std::size_t n = tile.points.size();
    if (labels_.size() < n + padding) labels_.resize(n + padding);
    for (std::size_t v = 0; v < n; ++v) labels_[v] = label_of(v, tile.owned[v] != 0);
    bits_.assign(n / word + 2, 0);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const D d;
    const DI di;
    V x_low = hn::Set(d, infinity), x_high = hn::Neg(x_low), y_low = x_low, y_high = x_high;
    for (std::size_t v = 0; v < n; v += lanes) {
      const auto is_owned =
          hn::And(hn::And(hn::LoadU(di, labels_.data() + v), hn::Set(di, 1)) == hn::Set(di, 1), hn::FirstN(di, n - v));
      bits_[v / word] |= bits_of(di, is_owned) << v % word;
      const auto owned = hn::RebindMask(d, is_owned);
      const V x = hn::LoadU(d, at.x.data() + v), y = hn::LoadU(d, at.y.data() + v);
      x_low = hn::IfThenElse(owned, hn::Min(x, x_low), x_low);
      x_high = hn::IfThenElse(owned, hn::Max(x, x_high), x_high);
      y_low = hn::IfThenElse(owned, hn::Min(y, y_low), y_low);
      y_high = hn::IfThenElse(owned, hn::Max(y, y_high), y_high);
    }
    box_ = {hn::GetLane(hn::MinOfLanes(d, x_low)), hn::GetLane(hn::MaxOfLanes(d, x_high)),
            hn::GetLane(hn::MinOfLanes(d, y_low)), hn::GetLane(hn::MaxOfLanes(d, y_high))};
  }

  /// Returns the box of the owned points, in TileCoordinates; low = ∞, high = −∞ if there are none.
  const Box& box() const { return box_; }

  /// Returns a bit for each of `word` points, the lowest for `point`: 1 if the tile owns it; 0 after the last point.
  HWY_INLINE Bits from(std::size_t point) const {
    const std::size_t first = point / word, skipped = point % word;
    return bits_[first] >> skipped | bits_[first + 1] << 1 << (word - 1 - skipped);
  }

  /// Returns for each point its label: twice its number, plus 1 if the tile owns the point.
  const std::int32_t* labels() const { return labels_.data(); }
  static std::size_t point_of(std::int32_t label) { return static_cast<std::size_t>(label) / 2; }

 private:
  using D = hn::CappedTag<float, 16>;
  using DI = hn::RebindToSigned<D>;
  using V = hn::Vec<D>;
  static constexpr std::size_t lanes = hn::MaxLanes(D());

  static std::int32_t label_of(std::size_t point, bool is_owned) {
    return static_cast<std::int32_t>(2 * point + std::size_t{is_owned});
  }

  std::vector<std::int32_t>& labels_;
  std::vector<Bits>& bits_;
  Box box_{};
};

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
