// What: where the centre of a ball may be that touches a point v: the sphere around v, without the cap that each other point
//       takes away. Its corners are the exposed triangles at v. Compiled once for each kind of vector unit; no include guard
//       but the compiler's own per kind.
// Law:  what is said is exact: each sign is certain, or decided by Ball::contains(). Where more would be needed than that, it
//       is said that the region is lost. docs/surface.md, section 5.
// How:  caps are taken away one after the other from the cycles of arcs that bound what is left. An arc is of the circle on
//       which the ball touches v and a point; it is kept shorter than 120 degrees by corners that are no triangles.
// Cost: a point that takes nothing away, two to four vector operations for each eight corners.
#if defined(RBPA_SPACE_STAR_FREE_REGION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_FREE_REGION_INL_H_
#undef RBPA_SPACE_STAR_FREE_REGION_INL_H_
#else
#define RBPA_SPACE_STAR_FREE_REGION_INL_H_
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
#include <utility>

#include "rbpa/base/lanes/mask_bits-inl.h"
#include "rbpa/space/predicate/ball.h"
#include "rbpa/space/star/few_caps-inl.h"
#include "rbpa/space/star/limits.h"
#include "rbpa/space/star/neighbor.h"
#include "rbpa/space/star/reach-inl.h"
#include "rbpa/space/star/taken_caps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class FreeRegion {
 public:
  using Vector = Vector3<double>;

  static constexpr std::size_t capacity = Reach::most_corners, max_waiting = 64;

  /// The whole sphere.
  void begin(double radius) {
    radius_ = radius;
    square_ = radius * radius;
    waiting_ = 0;
    caps_.begin(radius);
    live_ = held_ = 0;
    top_ = 0;
    has_begun_ = is_parted_ = false;
  }

  /// Takes the caps of a few points away at once, from the whole sphere.
  /// Returns: false, and the whole sphere is there, where not all is certain.
  bool start(std::span<const Neighbor> points) {
    if (!few_.find(points, radius_)) return false;
    for (const Neighbor& p : points) caps_.push(p);
    has_begun_ = true;
    const std::span<const FewCaps::Corner> corners = few_.corners();
    bool is_whole = corners.size() < capacity;
    for (std::size_t k = 0; k < corners.size() && is_whole; ++k)
      add(static_cast<std::uint32_t>(corners[k].about), static_cast<int>(corners[k].left), corners[k].at,
          corners[k].error);
    for (std::size_t k = 0; k < corners.size() && is_whole; ++k)
      link(static_cast<int>(k), static_cast<int>(corners[k].next));
    for (std::size_t k = 0; k < corners.size() && is_whole; ++k) is_whole = cut_long_arc(static_cast<int>(k));
    if (!is_whole) begin(radius_);
    return is_whole;
  }

  /// How many caps bound or have bounded it: where there are no more, the region is the same.
  std::size_t caps() const { return caps_.count(); }

  /// Nothing is left, whatever is taken away.
  bool is_empty() const { return has_begun_ && live_ == 0; }

  /// Takes the cap of p away. `is_in_ball(x, y, p)` says exactly whether p is in the ball on (v, x, y), of numbers.
  /// Returns: false when the region is lost.
  template <typename IsInBall>
  bool take(const Neighbor& p, IsInBall is_in_ball) {
    const Outcome outcome = cut(p, is_in_ball);
    if (outcome != Outcome::inside) return outcome == Outcome::taken;
    // Its circle is free as a whole, and so it stays unless another one crosses it.
    for (std::size_t i = 0; i < waiting_; ++i) {
      const Neighbor q = waits_[i];
      const Rests both = rests(p, q);
      if (both.cannot) continue;
      waits_[i] = waits_[--waiting_];
      const Outcome of_q = cut(q, is_in_ball);  // the region may have changed since q was tried
      if (of_q == Outcome::lost) return false;
      if (of_q == Outcome::taken) return take(p, is_in_ball);
      if (!both.are_certain || !caps_.leave_free(both.left, both.error) || !caps_.leave_free(both.right, both.error) ||
          caps_.count() + 2 > TakenCaps::most)
        return false;
      const auto number = static_cast<std::uint32_t>(caps_.count());
      caps_.push(p);
      caps_.push(q);
      const int a = add(number, static_cast<int>(number) + 1, both.left, both.error),
                b = a == none ? none : add(number + 1, static_cast<int>(number), both.right, both.error);
      if (b == none) return false;
      link(a, b);
      link(b, a);
      has_begun_ = true;
      return cut_long_arc(a) && cut_long_arc(b) && take_waiting(is_in_ball);
    }
    if (waiting_ == max_waiting) return false;
    waits_[waiting_++] = p;
    return true;
  }

  /// To be called when all have been taken: those whose circle was free are tried again, until none changes anything. What is
  /// left of them crosses nothing, so that no triangle is at it.
  template <typename IsInBall>
  bool finish(IsInBall is_in_ball) {
    for (std::size_t before = waiting_ + 1; waiting_ < before && waiting_ != 0 && !is_empty();) {
      before = waiting_;
      if (!take_waiting(is_in_ball)) return false;
    }
    return true;
  }

  /// Where it is not told, any point may reach the region.
  void tell_reach(Reach& reach) {
    reach.begin(radius_, top_, has_begun_);
    if (!has_begun_) return;
    for (std::uint64_t left = live_, part = 0; left != 0 && reach.is_told(); left &= ~part) {
      const int start = std::countr_zero(left);
      Vector sum = {0, 0, 0};
      part = 0;
      int k = start;
      do {
        sum = plus(sum, corner(k));
        part |= std::uint64_t{1} << k;
        k = next_[static_cast<std::size_t>(k)];
      } while (k != start);
      // Caps that cover a circle once do so for ever.
      is_parted_ = is_parted_ || caps_.cover_equator(sum);
      if (is_parted_)
        reach.add({x_.data(), y_.data(), z_.data(), top_}, part, sum);
      else
        reach.give_up();
    }
  }

  /// Calls visit(number) for the points about which the ball rolls, cycle by cycle, and end() after each cycle: from x to
  /// the next, z, it rolls from the exposed triangle (v, x, y) to (v, z, x).
  template <typename Visit, typename End>
  void for_each_cycle(Visit visit, End end) const {
    std::uint64_t left = live_;
    while (left != 0) {
      const int start = std::countr_zero(left);
      int k = start;
      do {
        const auto i = static_cast<std::size_t>(k);
        if (left_[i] != none) visit(static_cast<std::uint32_t>(caps_[about_[i]].number));
        left &= ~(std::uint64_t{1} << k);
        k = next_[i];
      } while (k != start);
      end();
    }
  }

 private:
  static constexpr double unit_roundoff = 0x1p-53;
  static constexpr int none = -1;

  enum class Outcome { taken, inside, lost };

  /// The two balls that rest on v, p and q: on (v, p, q) and on (v, q, p).
  struct Rests {
    Vector left{}, right{};
    double error = 0;
    // For certain; not bool, so that a copy is of whole registers, which can be read again at once.
    std::uint32_t are_certain = 0, cannot = 0;
  };
  struct Signs {
    std::uint64_t dead, near;              // corners in the ball, and those of which it is not certain
    std::uint64_t middle_on, far_side_on;  // arcs that the direction of p may be on, and the one away from it
  };

  Vector corner(int k) const {
    const auto i = static_cast<std::size_t>(k);
    return {x_[i], y_[i], z_[i]};
  }

  Rests rests(const Neighbor& p, const Neighbor& q) const {
    const Vector n = cross(p.at, q.at), w = minus(p.at, q.at);
    const double nn = dot(n, n), pp = 2 * p.power, qq = 2 * q.power, whole = 4 * square_ * nn;
    const double clearance = whole - pp * qq * dot(w, w);
    Rests both;
    both.are_certain = clearance > limits::flatness * whole;
    both.cannot = clearance < -limits::flatness * pp * qq * square_;
    if (!both.are_certain) return both;
    const double inverse = 0.5 / nn, rise = std::sqrt(clearance) * inverse;
    const Vector to_p = cross(q.at, n), to_q = cross(n, p.at);
    const Vector middle = scaled(plus(scaled(to_p, pp), scaled(to_q, qq)), inverse), up = scaled(n, rise);
    both.left = plus(middle, up);
    both.right = minus(middle, up);
    both.error = unit_roundoff * radius_ * (384 * pp * qq * inverse + 32 * whole / clearance + 32);
    both.are_certain = both.error < limits::error * radius_;
    return both;
  }

  /// A corner; none where there is no room.
  int add(std::uint32_t about, int left, const Vector& at, double error) {
    const std::uint64_t used = live_ | held_;
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

  /// An arc from corner a to b, about the point of a.
  void link(int a, int b) {
    const auto i = static_cast<std::size_t>(a);
    next_[i] = static_cast<std::uint8_t>(b);
    const Neighbor& q = caps_[about_[i]];
    const Vector from = cross(q.at, corner(a)), to = cross(corner(b), q.at);
    from_x_[i] = from.x;
    from_y_[i] = from.y;
    from_z_[i] = from.z;
    to_x_[i] = to.x;
    to_y_[i] = to.y;
    to_z_[i] = to.z;
    side_error_[i] = limits::slack * radius_ * q.length;
  }

  /// Where a turn by an angle is from 0 to 4, monotonously, of multiples of its sine and cosine; what is within the slack of 0
  /// is 0.
  static double turn(double sine, double cosine) {
    const double share = sine / (std::abs(sine) + std::abs(cosine));
    if (cosine < 0) return 2 - share;
    if (share > limits::slack) return share;
    return share < -limits::slack ? 4 + share : 0;
  }

  /// Puts corners that are no triangles on the arc from a, until no part has 120 degrees.
  bool cut_long_arc(int a) {
    while (true) {
      const auto i = static_cast<std::size_t>(a);
      const int b = next_[i];
      const Neighbor& q = caps_[about_[i]];
      const Vector middle = scaled(q.at, 0.5), u = minus(corner(a), middle), v = minus(corner(b), middle);
      const double square = square_ - q.power / 2;  // of the circle's radius
      const double sine = dot(q.at, cross(u, v)), cosine = dot(u, v);
      if (sine > 2 * limits::slack * q.length * square && cosine > -square / 2) return true;
      const double angle = turn(sine / q.length, cosine);
      if (angle < 1 || (angle < 2 && cosine > -square / 2)) return true;
      // Not in the very middle, where symmetric points would meet it.
      Vector m;
      if (cosine < -0.9 * square) {
        m = scaled(cross(q.at, u), 1 / q.length);
        m = plus(m, scaled(u, 0.05));
      } else {
        m = plus(scaled(u, 0.9), v);
        if (angle > 2) m = scaled(m, -1);
      }
      m = scaled(m, std::sqrt(square / dot(m, m)));
      const int k = add(about_[i], none, plus(middle, m), limits::error * 1e-3 * radius_);
      if (k == none) return false;
      link(k, b);
      link(a, k);
      if (!cut_long_arc(k)) return false;
    }
  }

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
      signs.dead |= bits(depth > error);
      signs.near |= bits(hn::Abs(depth) <= error);
      const auto from = product(from_x_.data(), from_y_.data(), from_z_.data());
      const auto to = product(to_x_.data(), to_y_.data(), to_z_.data());
      const auto side_error = hn::Load(d, side_error_.data() + i) * sizes;
      signs.middle_on |= bits(hn::Min(from, to) > hn::Neg(side_error));
      signs.far_side_on |= bits(hn::Max(from, to) < side_error);
    }
    signs.dead &= live_;
    signs.near &= live_;
    return signs;
  }

  /// The extent of p along the circle about q: whether its cap cuts it, −1 if no point of it or all of it is taken away.
  struct OnCircle {
    double most, least, error;
  };
  OnCircle on_circle(const Neighbor& p, double size, const Neighbor& q) const {
    const double along = dot(p.at, q.at), qq = 2 * q.power;
    const double across = std::sqrt(std::max(0.0, 2 * p.power - along * along / qq));
    const double reach = std::sqrt(std::max(0.0, square_ - qq / 4)) * across;
    return {along / 2 + reach - p.power, along / 2 - reach - p.power, limits::slack * 1e-2 * radius_ * size};
  }

  /// Tries those again that wait.
  template <typename IsInBall>
  bool take_waiting(IsInBall is_in_ball) {
    const std::size_t count = std::exchange(waiting_, 0);
    std::array<Neighbor, max_waiting> again;
    std::copy_n(waits_.begin(), count, again.begin());
    for (std::size_t k = 0; k < count; ++k)
      if (!take(again[k], is_in_ball)) return false;
    return true;
  }

  template <typename IsInBall>
  Outcome cut(const Neighbor& p, IsInBall is_in_ball) {
    if (caps_.count() == TakenCaps::most) return Outcome::lost;
    const double size = std::abs(p.at.x) + std::abs(p.at.y) + std::abs(p.at.z);
    const Signs signs = signs_of(p, size);
    std::uint64_t dead = signs.dead;
    for (std::uint64_t left = signs.near; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      const auto i = static_cast<std::size_t>(k);
      if (left_[i] == none) return Outcome::lost;
      if (is_in_ball(caps_[about_[i]].number, caps_[static_cast<std::size_t>(left_[i])].number, p.number))
        dead |= std::uint64_t{1} << k;
    }
    std::uint64_t dead_after = 0;
    if (dead != 0)
      for (std::uint64_t left = live_; left != 0; left &= left - 1) {
        const int k = std::countr_zero(left);
        dead_after |= (dead >> next_[static_cast<std::size_t>(k)] & 1) << k;
      }
    std::uint64_t bitten = live_ & ~dead & ~dead_after & signs.middle_on,
                  spared = dead & dead_after & signs.far_side_on;
    const std::uint64_t crossed = dead ^ dead_after;
    // Where p's direction is on an arc with free ends, or that away from it on one whose ends are held, the middle may differ.
    for (std::uint64_t left = bitten; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      const OnCircle on = on_circle(p, size, caps_[about_[static_cast<std::size_t>(k)]]);
      if (on.most < -on.error)
        bitten &= ~(std::uint64_t{1} << k);
      else if (!(on.most > on.error && is_between(k, p, size, 1)))
        return Outcome::lost;
    }
    for (std::uint64_t left = spared; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      const OnCircle on = on_circle(p, size, caps_[about_[static_cast<std::size_t>(k)]]);
      if (on.least > on.error)
        spared &= ~(std::uint64_t{1} << k);
      else if (!(on.least < -on.error && is_between(k, p, size, -1)))
        return Outcome::lost;
    }
    const std::uint64_t changed = bitten | spared | crossed;
    if (changed == 0) {
      if (!caps_.hold_some_of_circle(p)) return dead == 0 ? Outcome::inside : Outcome::lost;
      if (dead != 0) caps_.push(p);
      live_ &= ~dead;
      return Outcome::taken;
    }

    const std::size_t number = caps_.count();
    caps_.push(p);
    held_ = dead;  // their places are not used again before all is linked
    live_ &= ~dead;
    std::array<int, capacity> entries, exits;
    std::size_t entry_count = 0, exit_count = 0;
    // Most points are met twice, on one side and on the other.
    constexpr std::size_t known_size = 4;
    std::array<Rests, known_size> known;
    std::array<std::size_t, known_size> known_about;
    std::size_t known_count = 0;
    for (std::uint64_t left = changed; left != 0; left &= left - 1) {
      const int a = std::countr_zero(left);
      const auto i = static_cast<std::size_t>(a);
      const int b = next_[i];
      const std::uint64_t bit = std::uint64_t{1} << a;
      const std::uint16_t q = about_[i];
      std::size_t at = 0;
      while (at < known_count && known_about[at] != q) ++at;
      if (at == known_count) {
        if (known_count == known_size)
          at = 0;
        else
          ++known_count;
        known[at] = rests(p, caps_[q]);
        known_about[at] = q;
        if (!known[at].are_certain) return Outcome::lost;
      }
      const Rests& both = known[at];
      const bool enters = (bitten & bit) != 0 || (spared & bit) != 0 || (dead & bit) == 0;
      const bool leaves = (bitten & bit) != 0 || (spared & bit) != 0 || (dead & bit) != 0;
      int entry = none, exit = none;
      if (enters && (entry = add(static_cast<std::uint32_t>(number), q, both.left, both.error)) == none)
        return Outcome::lost;
      if (leaves && (exit = add(q, static_cast<int>(number), both.right, both.error)) == none) return Outcome::lost;
      if ((spared & bit) != 0) {
        link(exit, entry);
      } else {
        if (leaves) link(exit, b);
        if (enters) link(a, entry);
      }
      if (enters) entries[entry_count++] = entry;
      if (leaves) exits[exit_count++] = exit;
    }
    held_ = 0;
    if (entry_count != exit_count) return Outcome::lost;
    if (entry_count == 1) {
      link(entries[0], exits[0]);
      return cut_long_arc(entries[0]) ? Outcome::taken : Outcome::lost;
    }
    return pair(p, {entries.data(), entry_count}, {exits.data(), exit_count});
  }

  /// p's direction, or the one away from it, is between the ends of the arc for certain.
  bool is_between(int k, const Neighbor& p, double size, double sign) const {
    const auto i = static_cast<std::size_t>(k);
    const double from = p.at.x * from_x_[i] + p.at.y * from_y_[i] + p.at.z * from_z_[i];
    const double to = p.at.x * to_x_[i] + p.at.y * to_y_[i] + p.at.z * to_z_[i];
    return std::min(sign * from, sign * to) > side_error_[i] * size;
  }

  /// The arcs of p's own circle: from each entry to the exit that is next.
  Outcome pair(const Neighbor& p, std::span<const int> entries, std::span<const int> exits) {
    const Vector middle = scaled(p.at, 0.5);
    std::uint64_t used = 0;
    for (const int entry : entries) {
      const Vector from = minus(corner(entry), middle);
      double least = 5, second = 5;
      int best = none;
      for (const int exit : exits) {
        const Vector to = minus(corner(exit), middle);
        const double angle = turn(dot(p.at, cross(from, to)) / p.length, dot(from, to));
        if (angle < least) {
          second = least;
          least = angle;
          best = exit;
        } else if (angle < second) {
          second = angle;
        }
      }
      if (second - least < limits::slack || (used >> best & 1) != 0) return Outcome::lost;
      used |= std::uint64_t{1} << best;
      link(entry, best);
    }
    for (const int entry : entries)
      if (!cut_long_arc(entry)) return Outcome::lost;
    return Outcome::taken;
  }

  double radius_ = 0, square_ = 0;
  std::size_t waiting_ = 0;
  bool has_begun_ = false;  // there have been corners
  bool is_parted_ = false;  // caps cover a great circle, so that each part is on one side of a plane
  FewCaps few_;
  TakenCaps caps_;
  std::array<Neighbor, max_waiting> waits_;  // whose circles are free as a whole
  std::uint64_t live_ = 0, held_ = 0;
  std::size_t top_ = 0;  // places below it have been used
  // Of each corner k: the ball rests on (v, about, left) there, or on no third point; and the arc from it, about the same.
  std::array<std::uint16_t, capacity> about_;
  std::array<std::int16_t, capacity> left_;
  std::array<std::uint8_t, capacity> next_;
  alignas(64) std::array<double, capacity> x_{}, y_{}, z_{}, error_{};
  alignas(64) std::array<double, capacity> from_x_{}, from_y_{}, from_z_{}, to_x_{}, to_y_{}, to_z_{}, side_error_{};
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace rbpa::space
HWY_AFTER_NAMESPACE();

#endif
