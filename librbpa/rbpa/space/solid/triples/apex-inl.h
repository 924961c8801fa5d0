// What: finds the fourth corner of the tetrahedron on a side of a triangle (v, q, r), among the points near v, in
//       double precision.
// Law:  a result is certain or `open`. clip_triples-inl.h derives the quotients for numbers of any precision. In
//       apex-inl.h each lane is a point, and lengths are in units of the input.
#if defined(RBPA_SPACE_TRIPLES_APEX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_TRIPLES_APEX_INL_H_
#undef RBPA_SPACE_TRIPLES_APEX_INL_H_
#else
#define RBPA_SPACE_TRIPLES_APEX_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/solid/triples/near_points-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

using rbpa::HWY_NAMESPACE::bits_of;
using rbpa::HWY_NAMESPACE::mask_of;

/// The result of the search on one side of a triangle.
enum class Side {
  none,   ///< no tetrahedron of circumradius at most alpha has an apex after r
  found,  ///< one tetrahedron, whose fourth corner is apex()
  open,   ///< the filter cannot decide
};

class ApexSearch {
 public:
  explicit ApexSearch(double alpha) : alpha_(alpha) {}

  /// Computes the values that look() compares, for the triangle of v and the near points at positions q and r.
  HWY_INLINE void set_triangle(const NearPoints& near, std::size_t q, std::size_t r) {
    constexpr double roundoff = 0x1p-53;
    const Vector3<double> u = {near.dx[q], near.dy[q], near.dz[q]}, w = {near.dx[r], near.dy[r], near.dz[r]};
    const Vector3<double> n = cross(u, w);
    const double uu = dot(u, u), ww = dot(w, w), inverse = 1 / dot(n, n);
    const Vector3<double> m = {uu * w.x - ww * u.x, uu * w.y - ww * u.y, uu * w.z - ww * u.z};
    Vector3<double> x = cross(m, n);
    x = {x.x * inverse, x.y * inverse, x.z * inverse};
    const double kappa = std::sqrt(uu * ww * inverse), error = 512 * roundoff * kappa * alpha_ * alpha_;
    is_bounded_ = kappa < 0x1p40;  // false for NaN too
    least_b_ = 64 * roundoff * std::sqrt(uu * ww) * alpha_;
    const double left = alpha_ * alpha_ - dot(x, x) / 4;
    farthest_ = std::sqrt(std::max(0.0, left + error) * inverse);
    nearest_ = left > error ? std::sqrt((left - error) * inverse) : 0;
    const double loose = 16 * roundoff * kappa + 0x1p-40;  // the error of n is less than 6uκ of its length
    farthest_ *= 1 + loose;
    nearest_ *= 1 - loose;
    q_ = q, r_ = r, after_ = near.after();

    const Doubles d;
    const std::size_t size = near.size();
    if (above_.size() < size + double_lanes) {
      above_.resize(2 * size + double_lanes);
      below_.resize(2 * size + double_lanes);
    }
    const auto nx = hn::Set(d, 2 * n.x), ny = hn::Set(d, 2 * n.y), nz = hn::Set(d, 2 * n.z);
    const auto xx = hn::Set(d, x.x), xy = hn::Set(d, x.y), xz = hn::Set(d, x.z), e = hn::Set(d, error);
    const auto infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    auto upper = infinity, lower = hn::Neg(infinity), lower_strong = lower, upper_strong = infinity;
    is_flat_ = is_violated_ = false;
    for (std::size_t p = 0; p < size; p += double_lanes) {
      const auto px = hn::LoadU(d, &near.dx[p]), py = hn::LoadU(d, &near.dy[p]), pz = hn::LoadU(d, &near.dz[p]);
      const auto square = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
      const auto a = hn::NegMulAdd(px, xx, hn::NegMulAdd(py, xy, hn::NegMulAdd(pz, xz, square)));
      const auto b = hn::MulAdd(px, nx, hn::MulAdd(py, ny, hn::Mul(pz, nz)));
      const auto others = others_at(p, size);
      const auto is_near_plane = hn::And(others, hn::Le(hn::Abs(b), hn::Set(d, least_b_)));
      const auto weak_a = hn::Add(a, e), strong_a = hn::Sub(a, e);
      if (!hn::AllFalse(d, is_near_plane)) {
        // A point in or near the plane is inside all balls through the triangle, outside of all, or uncertain.
        const auto is_inside = hn::And(is_near_plane, hn::Lt(weak_a, hn::Neg(e)));
        const auto is_outside = hn::And(is_near_plane, hn::Gt(strong_a, e));
        if (!hn::AllFalse(d, is_inside)) is_violated_ = true;
        if (!hn::AllFalse(d, hn::AndNot(hn::Or(is_inside, is_outside), is_near_plane))) is_flat_ = true;
      }
      const auto is_above = hn::And(others, hn::Gt(b, hn::Set(d, least_b_)));
      const auto is_below = hn::And(others, hn::Lt(b, hn::Set(d, -least_b_)));
      const auto over = hn::Div(hn::Set(d, 1.0), b);
      const auto weak = hn::Mul(weak_a, over), strong = hn::Mul(strong_a, over);
      upper = hn::IfThenElse(is_above, hn::Min(weak, upper), upper);
      upper_strong = hn::IfThenElse(is_above, hn::Min(strong, upper_strong), upper_strong);
      lower = hn::IfThenElse(is_below, hn::Max(weak, lower), lower);
      lower_strong = hn::IfThenElse(is_below, hn::Max(strong, lower_strong), lower_strong);
      // A point in or near the plane is never the first point on a side.
      hn::StoreU(hn::IfThenElse(is_above, strong, infinity), d, &above_[p]);
      hn::StoreU(hn::IfThenElse(is_below, strong, hn::Neg(infinity)), d, &below_[p]);
    }
    upper_ = hn::GetLane(hn::MinOfLanes(d, upper));
    lower_ = hn::GetLane(hn::MaxOfLanes(d, lower));
    upper_strong_ = hn::GetLane(hn::MinOfLanes(d, upper_strong));
    lower_strong_ = hn::GetLane(hn::MaxOfLanes(d, lower_strong));
    size_ = size;
  }

  /// Returns the result for the side of positive t, the position of the center along the axis, if `is_positive`, else
  /// for the side of negative t. After Side::found, apex() is the position of the fourth corner among the near points.
  HWY_INLINE Side look(bool is_positive) {
    if (!is_bounded_) return Side::open;
    if (is_violated_) return Side::none;
    if (is_flat_) return Side::open;
    // The side of negative t is reflected to that of positive t. The first point on a side is the one with the least t.
    const double first_weak = is_positive ? upper_ : -lower_,
                 first_strong = is_positive ? upper_strong_ : -lower_strong_;
    const double last_weak = is_positive ? lower_ : -upper_, last_strong = is_positive ? lower_strong_ : -upper_strong_;
    if (first_strong > farthest_ || first_weak < -farthest_ || last_weak > first_weak) return Side::none;
    if (!(last_strong < first_strong && first_weak <= nearest_ && first_strong >= -nearest_)) return Side::open;
    const Doubles d;
    const std::vector<double>& of_side = is_positive ? above_ : below_;
    const auto sign = hn::Set(d, is_positive ? 1.0 : -1.0), bound = hn::Set(d, first_weak);
    std::size_t candidates = 0;
    for (std::size_t p = 0; p < size_; p += double_lanes) {
      const std::uint64_t first = bits_of(d, hn::Le(hn::Mul(hn::LoadU(d, &of_side[p]), sign), bound));
      if (first == 0) continue;
      candidates += static_cast<std::size_t>(std::popcount(first));
      apex_ = p + static_cast<std::size_t>(std::countr_zero(first));
    }
    return candidates != 1 ? Side::open : apex_ > r_ && apex_ < after_ ? Side::found : Side::none;
  }
  std::size_t apex() const { return apex_; }

 private:
  /// Returns the lanes, from position p on, of near points other than q and r.
  HWY_INLINE hn::Mask<Doubles> others_at(std::size_t p, std::size_t size) const {
    const Doubles d;
    std::uint64_t lanes = size - p < double_lanes ? (std::uint64_t{1} << (size - p)) - 1 : ~std::uint64_t{0};
    for (const std::size_t corner : {q_, r_})
      if (corner - p < double_lanes) lanes &= ~(std::uint64_t{1} << (corner - p));
    return mask_of(d, lanes);
  }

  double alpha_;
  std::size_t q_ = 0, r_ = 0, after_ = 0, size_ = 0, apex_ = 0;
  bool is_bounded_ = false;
  bool is_violated_ = false;  // a point in or near the plane is inside every ball
  bool is_flat_ = false;      // a point in or near the plane may touch every ball
  double least_b_ = 0;
  double farthest_ = 0, nearest_ = 0;  // bounds of T, the greatest |t| for radius alpha
  // upper_: the least (a + E) / b of points with b > least_b_; lower_: the greatest of points with b < −least_b_;
  // upper_strong_ and lower_strong_: likewise with a − E in place of a + E.
  double upper_ = 0, lower_ = 0, upper_strong_ = 0, lower_strong_ = 0;
  std::vector<double> above_, below_;  // (a − E) / b of near points above and below; else ±infinity
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
