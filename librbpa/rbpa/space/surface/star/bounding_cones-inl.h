// What: bounds the parts of a free region by cones from v. A point whose cap misses all cones changes nothing.
// Law:  conservative: a rejected point never changes the region. docs/explanation/surfaces.md, section 13.
// How:  a part on one side of a plane through v is in the cone of its corners. The corners are lengthened to C until
//       their hull is outside the sphere. Then p's cap meets the part only if C · p > p²/2 for some C.
//
//             C ───────── C'        hull of the lengthened corners: outside the sphere
//              ╲  ╭───╮  ╱
//               c╯  G  ╰c'          part G of the region, on the sphere of centers
//                ╲     ╱
//       ──────────╲   ╱──────────   plane through v, perpendicular to the sum of the corners
//                   v
//
//       Compiled once for each kind of vector unit: Highway's toggle is the include guard.
#if defined(RBPA_SPACE_STAR_BOUNDING_CONES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_BOUNDING_CONES_INL_H_
#undef RBPA_SPACE_STAR_BOUNDING_CONES_INL_H_
#else
#define RBPA_SPACE_STAR_BOUNDING_CONES_INL_H_
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

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/space/surface/star/limits.h"
#include "rbpa/space/surface/star/neighbor.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class BoundingCones {
 public:
  static constexpr std::size_t most_corners = 64, most_cones = 4;
  /// A circular cone in single precision, in units of the radius, for a first test: p's cap meets the cone only if
  /// middle · p + margin > p²/4. This holds even if p is off by 10⁻⁶.
  struct Cone {
    float x, y, z, margin;
  };
  /// Coordinates of corners, in arrays that are readable up to whole vectors.
  struct Corners {
    const double *x, *y, *z;
    std::size_t count;
  };

  /// Removes all cones, and sets the number of corners. Without a cone, all points are rejected if `is_bounded`, else
  /// none.
  void reset(double radius, std::size_t corners, bool is_bounded) {
    const hn::CappedTag<double, 8> d;
    inverse_ = 1 / radius;
    radius_ = radius;
    count_ = corners;
    cone_count_ = 0;
    error_ = 0;
    is_bounded_ = is_bounded;
    for (std::size_t i = 0; i < count_; i += hn::Lanes(d))
      for (auto* of : {&x_, &y_, &z_}) hn::Store(hn::Zero(d), d, of->data() + i);
  }

  /// Adds a part of the region. Its corners are the set bits of `part`; `sum` is the sum of these corners. If the part
  /// has no cone, no point is rejected any more.
  void add(const Corners& corners, std::uint64_t part, const Vector3<double>& sum) {
    is_bounded_ = is_bounded_ && cone_count_ < most_cones && lengthen(corners, part, sum);
  }
  void give_up() { is_bounded_ = false; }

  bool is_bounded() const { return is_bounded_; }
  std::span<const Cone> cones() const { return {cones_.data(), cone_count_}; }

  /// Returns false only if the cap of p certainly misses the region.
  bool may_meet_cap_of(const Neighbor& p) const {
    if (!is_bounded_) return true;
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
  /// Lengthens the corners of a part, and adds its cone. Returns false if the corners are not on one side of the plane
  /// perpendicular to their sum.
  bool lengthen(const Corners& corners, std::uint64_t part, const Vector3<double>& sum) {
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
      const auto lengthen = [&](const double* from, double center, double* to) {
        const V out = hn::Mul(hn::Load(d, from), hn::Set(d, longer));
        hn::Store(hn::IfThenElse(is_there, out, hn::Load(d, to)), d, to);
        return hn::Sub(out, hn::Set(d, center));
      };
      const V x = lengthen(corners.x + i, middle.x, &x_[i]), y = lengthen(corners.y + i, middle.y, &y_[i]),
              z = lengthen(corners.z + i, middle.z, &z_[i]);
      most = hn::Max(most, hn::IfThenElseZero(is_there, square_of(x, y, z)));
    }
    error_ = std::max(error_, 2 * limits::error * radius_ * longer);
    const double spread = hn::GetLane(hn::MaxOfLanes(d, most)) * inverse_ * inverse_;  // δ²
    // C · p ≤ M · p + δ|p| ≤ M · p + δ² + p²/4; no C is farther from v than `longer` radii.
    cones_[cone_count_++] = {
        static_cast<float>(middle.x * inverse_), static_cast<float>(middle.y * inverse_),
        static_cast<float>(middle.z * inverse_),
        static_cast<float>(spread + limits::rounding * (2 + longer + spread) + 4 * error_ * inverse_)};
    return true;
  }

  double radius_ = 1, inverse_ = 1;
  alignas(64) std::array<double, most_corners> x_{}, y_{}, z_{};  // lengthened; zeros where there is no corner
  std::size_t count_ = 0, cone_count_ = 0;
  std::array<Cone, most_cones> cones_;
  double error_ = 0;  // greatest error of a lengthened corner
  bool is_bounded_ = false;
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
