// What: keeps the caps that are subtracted from the sphere of a ball's centers, and tests whether their union covers a
//       point, a circle or a great circle.
// Law:  a "yes" is certain; a "no" means that "yes" could not be shown. Compiled once for each kind of vector unit:
//       Highway's toggle is the include guard.
#if defined(RBPA_SPACE_STAR_CAP_UNION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_CAP_UNION_INL_H_
#undef RBPA_SPACE_STAR_CAP_UNION_INL_H_
#else
#define RBPA_SPACE_STAR_CAP_UNION_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rbpa/space/surface/star/limits.h"
#include "rbpa/space/surface/star/neighbor.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class CapUnion {
 public:
  using Vector = Vector3<double>;
  /// Maximum number of caps; a region bounded by more is lost. Smooth surfaces need about ten, dense clusters some
  /// thousand.
  static constexpr std::size_t most = 32767;

  void reset(double radius) {
    radius_ = radius;
    count_ = 0;
  }
  /// Adds the cap of p. Requires: fewer than `most` caps.
  void push(const Neighbor& p) {
    if (count_ == points_.size()) grow();
    points_[count_] = p;
    x_[count_] = p.at.x;
    y_[count_] = p.at.y;
    z_[count_] = p.at.z;
    power_[count_] = p.power;
    length_[count_++] = p.length;
  }
  std::size_t count() const { return count_; }
  const Neighbor& operator[](std::size_t i) const { return points_[i]; }

  /// Returns true only if the center is outside every cap, even if each of its coordinates is wrong by up to `error`.
  bool misses(const Vector& center, double error) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const Neighbor& q = points_[i];
      if (dot(center, q.at) - q.power > -error * 2 * q.length) return false;  // Σ|qᵢ| is at most √3 |q|
    }
    return true;
  }

  /// Returns whether some cap covers place_on_circle(p), a point of the circle of p.
  bool meets_circle_of(const Neighbor& p) const {
    if (!has_circle(p)) return false;
    const Vector place = place_on_circle(p);
    const hn::CappedTag<double, 8> d;
    for (std::size_t i = 0; i < count_; i += hn::Lanes(d)) {
      const auto depth = hn::Sub(along(i, place), hn::LoadU(d, &power_[i]));
      const auto is_in = depth > hn::Mul(hn::Set(d, limits::slack * radius_), hn::LoadU(d, &length_[i]));
      if (!hn::AllFalse(d, hn::And(is_in, hn::FirstN(d, count_ - i)))) return true;
    }
    return false;
  }

  /// Returns whether no cap covers place_on_circle(p).
  bool misses_circle_of(const Neighbor& p) const {
    return has_circle(p) && misses(place_on_circle(p), limits::slack * radius_);
  }

  /// Removes the caps that lie within p's cap. Returns false if this is uncertain for some cap; the caps may then not
  /// be used further. Requires: p's circle is free, so that each other cap lies within p's cap or is disjoint from it.
  bool forget_within(const Neighbor& p) {
    for (std::size_t i = 0; i < count_; ++i) {
      if (points_[i].power == forgotten) continue;
      const double depth = dot(place_on_circle(points_[i]), p.at) - p.power, error = limits::slack * radius_ * p.length;
      if (depth < -error) continue;
      if (!(depth > error)) return false;
      points_[i].power = power_[i] = forgotten;
    }
    return true;
  }

  /// Returns whether the caps cover the great circle perpendicular to an axis. Of sixteen samples on the circle, each
  /// must be so deep in some cap that the cap covers the part of the circle nearer to this sample than to the next.
  bool covers_great_circle(const Vector& axis) const {
    constexpr std::size_t samples = 16;
    constexpr double gap = 0.1964;  // radii from any point of the circle to a sample: more than 2 sin(π / 32)
    constexpr double c1 = 0.92387953251128674, s1 = 0.38268343236508977, c2 = 0.70710678118654752;
    static constexpr double cosine[samples] = {1, c1, c2, s1, 0, -s1, -c2, -c1, -1, -c1, -c2, -s1, 0, s1, c2, c1};
    static constexpr double sine[samples] = {0, s1, c2, c1, 1, c1, c2, s1, 0, -s1, -c2, -c1, -1, -c1, -c2, -s1};
    const double square = dot(axis, axis);
    if (!(square > 1e-6 * radius_ * radius_)) return false;
    const Vector other = std::abs(axis.x) < std::abs(axis.y) ? Vector{1, 0, 0} : Vector{0, 1, 0};
    const Vector across = cross(axis, other);
    const Vector u = scaled(across, radius_ / std::sqrt(dot(across, across))),
                 v = scaled(cross(axis, u), 1 / std::sqrt(square));
    const hn::CappedTag<double, 8> d;
    std::uint32_t covered = 0;
    for (std::size_t n = 0; n < count_ && covered != 0xffff; n += hn::Lanes(d)) {
      const auto qu = along(n, u), qv = along(n, v),
                 needed = hn::IfThenElse(
                     hn::FirstN(d, count_ - n),
                     hn::MulAdd(hn::LoadU(d, &length_[n]), hn::Set(d, gap * radius_), hn::LoadU(d, &power_[n])),
                     hn::Set(d, std::numeric_limits<double>::infinity()));
      for (std::size_t i = 0; i < samples; ++i)
        if (!hn::AllFalse(d, hn::MulAdd(hn::Set(d, cosine[i]), qu, hn::Mul(hn::Set(d, sine[i]), qv)) > needed))
          covered |= 1U << i;
    }
    return covered == 0xffff;
  }

 private:
  bool has_circle(const Neighbor& p) const { return radius_ * radius_ > p.power / 2; }
  /// Returns a point of the circle of p, in the direction p × axis. The axis is the one along which p is least, so that
  /// the product is far from 0.
  Vector place_on_circle(const Neighbor& p) const {
    const Vector size = {std::abs(p.at.x), std::abs(p.at.y), std::abs(p.at.z)};
    const Vector axis = size.x <= size.y && size.x <= size.z ? Vector{1, 0, 0}
                        : size.y <= size.z                   ? Vector{0, 1, 0}
                                                             : Vector{0, 0, 1};
    const Vector across = cross(p.at, axis);
    const double square = radius_ * radius_ - p.power / 2;
    return plus(scaled(p.at, 0.5), scaled(across, std::sqrt(square / dot(across, across))));
  }
  /// Returns the scalar products of w with points i, i + 1, …, one in each lane.
  HWY_INLINE hn::Vec<hn::CappedTag<double, 8> > along(std::size_t i, const Vector& w) const {
    const hn::CappedTag<double, 8> d;
    return hn::MulAdd(
        hn::LoadU(d, &x_[i]), hn::Set(d, w.x),
        hn::MulAdd(hn::LoadU(d, &y_[i]), hn::Set(d, w.y), hn::Mul(hn::LoadU(d, &z_[i]), hn::Set(d, w.z))));
  }

  /// Grows the arrays; their sizes remain multiples of a vector.
  void grow() {
    const std::size_t size = std::max<std::size_t>(256, 2 * points_.size());
    points_.resize(size);
    for (std::vector<double>* values : {&x_, &y_, &z_, &power_, &length_}) values->resize(size);
  }

  static constexpr double forgotten = std::numeric_limits<double>::infinity();  // a power that no depth exceeds

  double radius_ = 0;
  std::size_t count_ = 0;
  std::vector<Neighbor> points_;
  std::vector<double> x_, y_, z_, power_, length_;  // the numbers of points_, in arrays for vectors
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
