// What: keeps the boundary of a free region: cycles of corners and of the arcs between them, on the sphere of a ball's
//       centers.
// Law:  arcs are shorter than 120 degrees; where necessary, corners that are not triangles divide them.
//       docs/explanation/surfaces.md, section 13.
// How:  corner k and the arc from it to corner next[k] have the same position in all arrays, so that one loop over
//       vector lanes tests a point against all of them. Sets of corners or arcs are the bits of a word. Compiled once
//       for each kind of vector unit: Highway's toggle is the include guard.
#if defined(RBPA_SPACE_STAR_REGION_BOUNDARY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_REGION_BOUNDARY_INL_H_
#undef RBPA_SPACE_STAR_REGION_BOUNDARY_INL_H_
#else
#define RBPA_SPACE_STAR_REGION_BOUNDARY_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/space/surface/star/bounding_cones-inl.h"
#include "rbpa/space/surface/star/limits.h"
#include "rbpa/space/surface/star/neighbor.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class RegionBoundary {
 public:
  using Vector = Vector3<double>;
  static constexpr std::size_t capacity = 64;  // number of corners: the bits of a word, and whole vectors
  static constexpr int none = -1;

  void reset(double radius) {
    radius_ = radius;
    square_ = radius * radius;
    live_ = retired_ = 0;
    top_ = 0;
  }

  /// Returns the set of existing corners, which is also the set of existing arcs.
  std::uint64_t live() const { return live_; }
  /// Returns the cap `about` of corner k: the ball rests on (v, about, left) there, and the arc from k is on the circle
  /// of `about`. Both are numbers of caps; `left` is none where the corner is not a triangle.
  std::size_t about(int k) const { return about_[static_cast<std::size_t>(k)]; }
  int left(int k) const { return left_[static_cast<std::size_t>(k)]; }
  int next(int k) const { return next_[static_cast<std::size_t>(k)]; }
  Vector corner(int k) const {
    const auto i = static_cast<std::size_t>(k);
    return {x_[i], y_[i], z_[i]};
  }
  BoundingCones::Corners corners() const { return {x_.data(), y_.data(), z_.data(), top_}; }

  /// Calls visit(k) for the corners of the cycle of corner `start`. Returns these corners.
  template <typename Visit>
  HWY_INLINE std::uint64_t for_each_in_cycle(int start, Visit visit) const {
    std::uint64_t cycle = 0;
    int k = start;
    do {
      visit(k);
      cycle |= std::uint64_t{1} << k;
      k = next(k);
    } while (k != start);
    return cycle;
  }

  /// Returns the arcs that end at one of `corners`.
  std::uint64_t arcs_to(std::uint64_t corners) const {
    std::uint64_t arcs = 0;
    if (corners != 0)
      for (std::uint64_t left = live_; left != 0; left &= left - 1) {
        const int k = std::countr_zero(left);
        arcs |= (corners >> next(k) & 1) << k;
      }
    return arcs;
  }

  /// Adds a corner. Returns its number, or none if there is no room.
  int add(std::size_t about, int left, const Vector& at, double error) {
    const std::uint64_t used = live_ | retired_;
    if (~used == 0) return none;
    const int k = std::countr_zero(~used);
    const auto i = static_cast<std::size_t>(k);
    live_ |= std::uint64_t{1} << k;
    if (i >= top_) top_ = i + 1;
    about_[i] = static_cast<std::uint16_t>(about);
    left_[i] = static_cast<std::int16_t>(left);
    x_[i] = at.x;
    y_[i] = at.y;
    z_[i] = at.z;
    error_[i] = error;
    return k;
  }

  /// Removes corners. Their numbers are not used again before release(), as arcs may still refer to them.
  void retire(std::uint64_t corners) {
    live_ &= ~corners;
    retired_ = corners;
  }
  void release() { retired_ = 0; }

  /// Makes the arc from corner a to b, on the circle of q, which is the point of about(a).
  void link(int a, int b, const Neighbor& q) {
    const auto i = static_cast<std::size_t>(a);
    next_[i] = static_cast<std::uint8_t>(b);
    const Vector from = cross(q.at, corner(a)), to = cross(corner(b), q.at);
    from_x_[i] = from.x;
    from_y_[i] = from.y;
    from_z_[i] = from.z;
    to_x_[i] = to.x;
    to_y_[i] = to.y;
    to_z_[i] = to.z;
    side_error_[i] = limits::slack * radius_ * q.length;
  }

  /// Divides the arc from a, on the circle of q, by corners that are not triangles, until every part is shorter than
  /// 120 degrees. Returns false if there is no room.
  bool subdivide(int a, const Neighbor& q) {
    while (true) {
      const int b = next(a);
      const Vector middle = scaled(q.at, 0.5), u = minus(corner(a), middle), v = minus(corner(b), middle);
      const double square = square_ - q.power / 2;  // of the circle's radius
      const double sine = dot(q.at, cross(u, v)), cosine = dot(u, v);
      if (sine > 2 * limits::slack * q.length * square && cosine > -square / 2) return true;
      const double angle = pseudo_angle(sine / q.length, cosine);
      if (angle < 1 || (angle < 2 && cosine > -square / 2)) return true;
      // The new corner is not in the middle, where circles of symmetric points would pass through it.
      Vector m;
      if (cosine < -0.9 * square) {
        m = scaled(cross(q.at, u), 1 / q.length);
        m = plus(m, scaled(u, 0.05));
      } else {
        m = plus(scaled(u, 0.9), v);
        if (angle > 2) m = scaled(m, -1);
      }
      m = scaled(m, std::sqrt(square / dot(m, m)));
      const int k = add(about(a), none, plus(middle, m), limits::placed * radius_);
      if (k == none) return false;
      link(k, b, q);
      link(a, k, q);
      if (!subdivide(k, q)) return false;
    }
  }

  /// Makes the arcs on p's own circle, from each entry to the next exit. Returns false if the next exit is not certain,
  /// or there is no room.
  bool link_around(const Neighbor& p, std::span<const int> entries, std::span<const int> exits) {
    const Vector middle = scaled(p.at, 0.5);
    std::uint64_t used = 0;
    for (const int entry : entries) {
      const Vector from = minus(corner(entry), middle);
      double least = 5, second = 5;  // above all angles
      int best = none;
      for (const int exit : exits) {
        const Vector to = minus(corner(exit), middle);
        const double angle = pseudo_angle(dot(p.at, cross(from, to)) / p.length, dot(from, to));
        if (angle < least) {
          second = least;
          least = angle;
          best = exit;
        } else if (angle < second) {
          second = angle;
        }
      }
      if (second - least < limits::slack || (used >> best & 1) != 0) return false;
      used |= std::uint64_t{1} << best;
      link(entry, best, p);
    }
    return std::all_of(entries.begin(), entries.end(), [&](int entry) { return subdivide(entry, p); });
  }

  /// The signs of corners and arcs with respect to a point p.
  struct Signs {
    std::uint64_t covered, uncertain;        // corners in p's cap, and corners for which that is uncertain
    std::uint64_t direction_on, reverse_on;  // arcs that may contain the direction of p, and the opposite direction
  };
  // Corner k and arc k are in one lane:
  //
  //   lane          k                k + 1            …
  //   x_ y_ z_    │ corner k        │ corner k + 1   │    depth  = corner · p − p²/2, above 0 in the cap
  //   from_       │ q × corner      │ …              │    p · from > 0: p's direction is after the beginning of the arc
  //   to_         │ next × q        │ …              │    p · to > 0:   p's direction is before its end
  HWY_INLINE Signs signs_of(const Neighbor& p, double size) const {
    const hn::CappedTag<double, 8> d;
    const auto px = hn::Set(d, p.at.x), py = hn::Set(d, p.at.y), pz = hn::Set(d, p.at.z), power = hn::Set(d, p.power),
               sizes = hn::Set(d, size);
    Signs signs = {0, 0, 0, 0};
    for (std::size_t i = 0; i < top_; i += hn::Lanes(d)) {
      const auto product = [&](const double* x, const double* y, const double* z) {
        return hn::MulAdd(hn::Load(d, x + i), px, hn::MulAdd(hn::Load(d, y + i), py, hn::Mul(hn::Load(d, z + i), pz)));
      };
      const auto bits = [&](auto mask) { return rbpa::HWY_NAMESPACE::bits_of(d, mask) << i; };
      const auto depth = product(x_.data(), y_.data(), z_.data()) - power;
      const auto error = hn::Load(d, error_.data() + i) * sizes;
      signs.covered |= bits(depth > error);
      signs.uncertain |= bits(hn::Abs(depth) <= error);
      const auto from = product(from_x_.data(), from_y_.data(), from_z_.data());
      const auto to = product(to_x_.data(), to_y_.data(), to_z_.data());
      const auto side_error = hn::Load(d, side_error_.data() + i) * sizes;
      signs.direction_on |= bits(hn::Min(from, to) > hn::Neg(side_error));
      signs.reverse_on |= bits(hn::Max(from, to) < side_error);
    }
    signs.covered &= live_;
    signs.uncertain &= live_;
    return signs;
  }

  /// Returns whether the direction of p times `sign` is certainly on the arc from corner k.
  bool has_on_arc(int k, const Neighbor& p, double size, double sign) const {
    const auto i = static_cast<std::size_t>(k);
    const double from = p.at.x * from_x_[i] + p.at.y * from_y_[i] + p.at.z * from_z_[i];
    const double to = p.at.x * to_x_[i] + p.at.y * to_y_[i] + p.at.z * to_z_[i];
    return std::min(sign * from, sign * to) > side_error_[i] * size;
  }

 private:
  /// Returns a monotone function of an angle, from 0 to 4 for a full turn, given multiples of its sine and cosine.
  /// Values within the slack of 0 are 0.
  static double pseudo_angle(double sine, double cosine) {
    const double share = sine / (std::abs(sine) + std::abs(cosine));
    if (cosine < 0) return 2 - share;
    if (share > limits::slack) return share;
    return share < -limits::slack ? 4 + share : 0;
  }

  double radius_ = 0, square_ = 0;
  std::uint64_t live_ = 0, retired_ = 0;
  std::size_t top_ = 0;  // positions from top_ on have never been used
  std::array<std::uint16_t, capacity> about_;
  std::array<std::int16_t, capacity> left_;
  std::array<std::uint8_t, capacity> next_;
  alignas(64) std::array<double, capacity> x_{}, y_{}, z_{}, error_{};
  alignas(64) std::array<double, capacity> from_x_{}, from_y_{}, from_z_{}, to_x_{}, to_y_{}, to_z_{}, side_error_{};
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
