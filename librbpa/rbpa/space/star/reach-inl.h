// What: which points may take anything away from what is left of the sphere of a ball's centres.
// Law:  a point that is said not to reach takes nothing away, now or later. docs/surface.md, section 5.
// How:  where each part of the region is on one side of a plane through v, c · p > power of p for one of its corners c, drawn
//       out as each part asks for. Compiled once for each kind of vector unit; no include guard but the compiler's own.
#if defined(RBPA_SPACE_STAR_REACH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_REACH_INL_H_
#undef RBPA_SPACE_STAR_REACH_INL_H_
#else
#define RBPA_SPACE_STAR_REACH_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "rbpa/base/lanes/mask_bits-inl.h"
#include "rbpa/space/star/limits.h"
#include "rbpa/space/star/neighbor.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class Reach {
 public:
  static constexpr std::size_t most_corners = 64, most_parts = 4;
  /// In radii: where p reaches it, middle · p + margin > p²/4, even if p is off by 10⁻⁶.
  struct Part {
    float x, y, z, margin;
  };
  /// Coordinates of corners, as many as are asked for and up to whole vectors.
  struct Corners {
    const double *x, *y, *z;
    std::size_t count;
  };

  /// Any point may reach the region; or none, as it has no part yet.
  void begin(double radius, std::size_t corners, bool is_told) {
    const hn::CappedTag<double, 8> d;
    inverse_ = 1 / radius;
    radius_ = radius;
    count_ = corners;
    parts_ = 0;
    error_ = 0;
    is_told_ = is_told;
    for (std::size_t i = 0; i < count_; i += hn::Lanes(d))
      for (auto* of : {&x_, &y_, &z_}) hn::Store(hn::Zero(d), d, of->data() + i);
  }

  /// One part more, bounded by the corners of set bits, which have a sum. Where that can not be told, any point may reach it.
  void add(const Corners& corners, std::uint64_t part, const Vector3<double>& sum) {
    is_told_ = is_told_ && parts_ < most_parts && draw_out(corners, part, sum);
  }
  void give_up() { is_told_ = false; }

  bool is_told() const { return is_told_; }
  std::span<const Part> parts() const { return {part_.data(), parts_}; }

  /// p may take something away.
  bool is_within(const Neighbor& p) const {
    if (!is_told_) return true;
    const hn::CappedTag<double, 8> d;
    const auto x = hn::Set(d, p.at.x), y = hn::Set(d, p.at.y), z = hn::Set(d, p.at.z),
               least = hn::Set(d, p.power - error_ * p.size());
    for (std::size_t i = 0; i < count_; i += hn::Lanes(d)) {
      const auto product =
          hn::MulAdd(hn::Load(d, &x_[i]), x, hn::MulAdd(hn::Load(d, &y_[i]), y, hn::Mul(hn::Load(d, &z_[i]), z)));
      if (!hn::AllFalse(d, product > least)) return true;
    }
    return false;
  }

 private:
  /// Returns: whether the corners are on one side of the plane square to their sum.
  bool draw_out(const Corners& corners, std::uint64_t part, const Vector3<double>& sum) {
    const hn::CappedTag<double, 8> d;
    using V = hn::Vec<decltype(d)>;
    const auto square_of = [](V x, V y, V z) { return hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z))); };
    auto least = hn::Set(d, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < corners.count; i += hn::Lanes(d)) {
      const V along = hn::MulAdd(hn::Load(d, corners.x + i), hn::Set(d, sum.x),
                                 hn::MulAdd(hn::Load(d, corners.y + i), hn::Set(d, sum.y),
                                            hn::Mul(hn::Load(d, corners.z + i), hn::Set(d, sum.z))));
      least = hn::Min(least, hn::IfThenElse(rbpa::HWY_NAMESPACE::mask_of(d, part >> i), along, least));
    }
    const double depth =
        hn::GetLane(hn::MinOfLanes(d, least)) / std::sqrt(dot(sum, sum));  // along their mean direction
    if (!(depth > limits::slack * radius_)) return false;
    const double longer = radius_ / (depth * (1 - limits::slack));
    const double share = longer / std::popcount(part);
    const Vector3<double> middle = {sum.x * share, sum.y * share, sum.z * share};
    auto most = hn::Zero(d);
    for (std::size_t i = 0; i < corners.count; i += hn::Lanes(d)) {
      const auto is_there = rbpa::HWY_NAMESPACE::mask_of(d, part >> i);
      const auto draw = [&](const double* from, double center, double* to) {
        const V out = hn::Mul(hn::Load(d, from), hn::Set(d, longer));
        hn::Store(hn::IfThenElse(is_there, out, hn::Load(d, to)), d, to);
        return hn::Sub(out, hn::Set(d, center));
      };
      const V x = draw(corners.x + i, middle.x, &x_[i]), y = draw(corners.y + i, middle.y, &y_[i]),
              z = draw(corners.z + i, middle.z, &z_[i]);
      most = hn::Max(most, hn::IfThenElseZero(is_there, square_of(x, y, z)));
    }
    error_ = std::max(error_, 2 * limits::error * radius_ * longer);
    const double spread = hn::GetLane(hn::MaxOfLanes(d, most)) * inverse_ * inverse_;
    // c · p is at most middle · p + spread |p|, and that is at most middle · p + spread² + p²/4; no corner is farther away than `longer` radii.
    part_[parts_++] = {static_cast<float>(middle.x * inverse_), static_cast<float>(middle.y * inverse_),
                       static_cast<float>(middle.z * inverse_),
                       static_cast<float>(spread + limits::rounding * (2 + longer + spread) + 4 * error_ * inverse_)};
    return true;
  }

  double radius_ = 1, inverse_ = 1;
  alignas(64) std::array<double, most_corners> x_{}, y_{}, z_{};  // zeros where there is no corner
  std::size_t count_ = 0, parts_ = 0;
  std::array<Part, most_parts> part_;
  double error_ = 0;  // of a corner
  bool is_told_ = false;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace rbpa::space
HWY_AFTER_NAMESPACE();

#endif
