// What: computes the free region: the possible centers of a ball that touches a point v and contains no other point.
//       The region is the sphere of centers around v less one cap for each other point. Its corners are the exposed
//       triangles at v.
// Law:  exact: each sign is certain, or decided by RestingBall::contains(). If neither is possible, or there is no
//       room, the region is lost, and the function returns false. docs/explanation/surfaces.md, section 13.
// How:  caps are subtracted one after the other (cut()) from the cycles of arcs that bound the region. An arc is part
//       of the circle of a point, on which the ball touches v and that point. Compiled once for each kind of vector
//       unit: Highway's toggle is the include guard.
// Cost: for a point whose cap changes nothing, two to four vector operations for every eight corners.
#if defined(RBPA_SPACE_STAR_FREE_REGION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_FREE_REGION_INL_H_
#undef RBPA_SPACE_STAR_FREE_REGION_INL_H_
#else
#define RBPA_SPACE_STAR_FREE_REGION_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/space/predicate/resting_ball.h"
#include "rbpa/space/surface/star/ball_pair-inl.h"
#include "rbpa/space/surface/star/bounding_cones-inl.h"
#include "rbpa/space/surface/star/cap_union-inl.h"
#include "rbpa/space/surface/star/circles.h"
#include "rbpa/space/surface/star/initial_region-inl.h"
#include "rbpa/space/surface/star/limits.h"
#include "rbpa/space/surface/star/neighbor.h"
#include "rbpa/space/surface/star/region_boundary-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class FreeRegion {
 public:
  using Vector = Vector3<double>;

  /// Resets the region to the whole sphere.
  void reset(double radius) {
    radius_ = radius;
    waiting_.clear();
    begin();
  }

  /// Subtracts the caps of a few points together from the whole sphere. Returns false, and leaves the whole sphere, if
  /// a sign is not certain.
  bool start(std::span<const Neighbor> points) {
    if (!initial_.find(points, radius_)) return false;
    for (const Neighbor& p : points) caps_.push(p);
    has_begun_ = true;
    static_assert(InitialRegion::most_corners <= RegionBoundary::capacity);
    const std::span<const InitialRegion::Corner> corners = initial_.corners();
    for (const auto& corner : corners)
      boundary_.add(corner.about, static_cast<int>(corner.left), corner.at, corner.error);
    for (std::size_t k = 0; k < corners.size(); ++k)
      boundary_.link(static_cast<int>(k), static_cast<int>(corners[k].next), caps_[corners[k].about]);
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (!boundary_.subdivide(static_cast<int>(k), caps_[corners[k].about])) {
        reset(radius_);
        return false;
      }
    return true;
  }

  /// Returns the number of caps that bound the region or have bounded it. The region changes only if this number does.
  std::size_t caps() const { return caps_.count(); }

  /// Returns whether the region is empty. An empty region stays empty.
  bool is_empty() const { return has_begun_ && boundary_.live() == 0; }

  /// Subtracts the cap of p. `is_in_ball(x, y, p)` decides exactly whether p is in the ball on (v, x, y), all given by
  /// Neighbor::site. Returns false when a sign cannot be decided, or there is no room: then the region is lost, and
  /// only reset() may follow.
  template <typename IsInBall>
  bool subtract(const Neighbor& p, IsInBall is_in_ball) {
    const std::size_t before = caps_.count();
    const Outcome outcome = cut(p, is_in_ball);
    if (outcome == Outcome::circle_is_free) return await_crossing(p, is_in_ball);
    if (outcome == Outcome::lost) return false;
    // Waiting circles that p's circle crosses are tried: their caps cover corners that farther points would add.
    return waiting_.count() == 0 || caps_.count() == before ||
           retry_waiting(is_in_ball, [&](const Neighbor& q) { return !crossing_of(p, q, radius_).is_impossible; });
  }

  /// Finishes the region: tries waiting caps again until none changes the region. The circles that still wait cross no
  /// other, so no triangle is on them. Returns false if the region is lost. Requires: all caps subtracted.
  template <typename IsInBall>
  bool finish(IsInBall is_in_ball) {
    for (std::size_t before = waiting_.count() + 1;
         waiting_.count() < before && waiting_.count() != 0 && !is_empty();) {
      before = waiting_.count();
      if (!retry_waiting(is_in_ball)) return false;
    }
    return true;
  }

  /// Replaces the cones in `bound` by cones that bound the region.
  void update_bound(BoundingCones& bound) {
    const BoundingCones::Corners corners = boundary_.corners();
    static_assert(BoundingCones::most_corners == RegionBoundary::capacity);
    bound.reset(radius_, corners.count, has_begun_);
    if (!has_begun_) return;
    for (std::uint64_t left = boundary_.live(), part = 0; left != 0 && bound.is_bounded(); left &= ~part) {
      Vector sum = {0, 0, 0};
      part = boundary_.for_each_in_cycle(std::countr_zero(left), [&](int k) { sum = plus(sum, boundary_.corner(k)); });
      // Coverage only grows, so that is_parted_ remains true.
      is_parted_ = is_parted_ || caps_.covers_great_circle(sum);
      if (is_parted_)
        bound.add(corners, part, sum);
      else
        bound.give_up();
    }
  }

  /// Calls visit(site) for the points about which the ball rolls, cycle by cycle, and end() after each cycle. About x,
  /// between its predecessor y and successor z in the cycle, the ball rolls from the exposed triangle (v, x, y) to (v,
  /// z, x).
  template <typename Visit, typename End>
  void for_each_cycle(Visit visit, End end) const {
    for (std::uint64_t left = boundary_.live(), cycle = 0; left != 0; left &= ~cycle) {
      cycle = boundary_.for_each_in_cycle(std::countr_zero(left), [&](int k) {
        if (boundary_.left(k) != none) visit(static_cast<std::uint32_t>(caps_[boundary_.about(k)].site));
      });
      end();
    }
  }

 private:
  static constexpr int none = RegionBoundary::none;

  enum class Outcome {
    done,            // the cap is subtracted
    circle_is_free,  // the cap is not subtracted: its circle crosses no arc and is free as a whole
    lost
  };

  /// Removes all caps and corners; waiting circles keep waiting.
  void begin() {
    caps_.reset(radius_);
    boundary_.reset(radius_);
    has_begun_ = is_parted_ = false;
  }

  /// The effect of a cap on the boundary: sets of corners, and of arcs by their first corners.
  struct Cut {
    std::uint64_t covered;  // corners that are in the cap
    std::uint64_t crossed;  // arcs with one end in the cap
    std::uint64_t bitten;   // arcs with no end in the cap, but with a part of their interior in it
    std::uint64_t spared;   // arcs with both ends in the cap, but not with their whole interior

    std::uint64_t arcs() const { return crossed | bitten | spared; }
    bool enters(std::uint64_t arc) const { return ((bitten | spared | ~covered) & arc) != 0; }
    bool leaves(std::uint64_t arc) const { return ((bitten | spared | covered) & arc) != 0; }
  };

  /// The corners at which the boundary enters the cap, and from there follows the cap's circle; and the corners at
  /// which the boundary leaves the cap.
  struct OwnArcs {
    std::array<int, RegionBoundary::capacity> entries, exits;
    std::size_t entry_count = 0, exit_count = 0;
  };

  /// Subtracts the cap of p from the region, if its circle crosses the boundary or is covered as a whole:
  ///   1. find the corners that the cap covers;
  ///   2. find the arcs that its circle crosses, by the arcs' ends or, where these do not decide, by their extremes;
  ///   3. if there are none, the circle is covered or free as a whole;
  ///   4. otherwise cut these arcs, with new corners at the crossings;
  ///   5. close the boundary along p's own circle, from each entry to the next exit.
  template <typename IsInBall>
  HWY_INLINE Outcome cut(const Neighbor& p, IsInBall is_in_ball) {
    if (caps_.count() == CapUnion::most) return Outcome::lost;
    const double size = p.size();
    RegionBoundary::Signs signs = boundary_.signs_of(p, size);
    if (signs.uncertain != 0 && !decide(p, is_in_ball, signs)) return Outcome::lost;
    Cut cut = cut_by_ends(signs);
    if (!test_interiors(p, size, cut)) return Outcome::lost;
    if (cut.arcs() == 0) return cut_nothing(p, cut);

    const auto cap = static_cast<int>(caps_.count());
    caps_.push(p);
    boundary_.retire(cut.covered);
    OwnArcs own;
    if (!cut_arcs(p, cap, cut, own)) return Outcome::lost;
    boundary_.release();
    return close(p, own) ? Outcome::done : Outcome::lost;
  }

  /// Step 1: decides which uncertain corners the cap covers. Returns false if an uncertain corner is not a triangle.
  template <typename IsInBall>
  bool decide(const Neighbor& p, IsInBall is_in_ball, RegionBoundary::Signs& signs) const {
    for (std::uint64_t left = signs.uncertain; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      if (boundary_.left(k) == none) return false;
      const std::size_t x = caps_[boundary_.about(k)].site, y = caps_[static_cast<std::size_t>(boundary_.left(k))].site;
      if (is_in_ball(x, y, p.site)) signs.covered |= std::uint64_t{1} << k;
    }
    return true;
  }

  /// Step 2a: classifies arcs by their ends. Bitten and spared arcs are still candidates.
  Cut cut_by_ends(const RegionBoundary::Signs& signs) const {
    const std::uint64_t ends = boundary_.arcs_to(signs.covered);
    return {.covered = signs.covered,
            .crossed = signs.covered ^ ends,
            .bitten = boundary_.live() & ~signs.covered & ~ends & signs.direction_on,
            .spared = signs.covered & ends & signs.reverse_on};
  }

  /// Step 2b: tests the extremes of arcs whose interior p's cap may cut although their ends do not show it. Drops the
  /// arcs that the cap does not cut. Returns whether all signs are certain.
  bool test_interiors(const Neighbor& p, double size, Cut& cut) const {
    for (std::uint64_t left = cut.bitten; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      const CircleDepths on_circle = depths_on_circle(p, size, caps_[boundary_.about(k)], radius_);
      if (on_circle.greatest > on_circle.error && boundary_.has_on_arc(k, p, size, 1)) continue;
      if (!(on_circle.greatest < -on_circle.error) && !is_opposite(k, p, on_circle, 1)) return false;
      cut.bitten &= ~(std::uint64_t{1} << k);
    }
    for (std::uint64_t left = cut.spared; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      const CircleDepths on_circle = depths_on_circle(p, size, caps_[boundary_.about(k)], radius_);
      if (on_circle.least < -on_circle.error && boundary_.has_on_arc(k, p, size, -1)) continue;
      if (!(on_circle.least > on_circle.error) && !is_opposite(k, p, on_circle, -1)) return false;
      cut.spared &= ~(std::uint64_t{1} << k);
    }
    return true;
  }

  /// Returns whether the direction of p times `sign` is certainly not on the arc from corner k: whether it is more than
  /// 120 degrees from both ends. Depth is a cosine along the circle. For an arc of length 0, as on a grid, no other
  /// test shows this.
  bool is_opposite(int k, const Neighbor& p, const CircleDepths& on_circle, double sign) const {
    const double middle = (on_circle.greatest + on_circle.least) / 2, half = (on_circle.greatest - on_circle.least) / 2;
    const auto is_far = [&](int corner) {
      return sign * (dot(boundary_.corner(corner), p.at) - p.power - middle) < -0.75 * half - on_circle.error;
    };
    return is_far(k) && is_far(boundary_.next(k));
  }

  /// Step 3: p's circle crosses no arc, so each cycle is entirely in the cap or outside of it. If one point of the
  /// circle is covered, the whole circle is; if one point is free, the whole circle is.
  Outcome cut_nothing(const Neighbor& p, const Cut& cut) {
    if (caps_.meets_circle_of(p)) {
      if (cut.covered != 0) caps_.push(p);
      boundary_.retire(cut.covered);
      boundary_.release();
      return Outcome::done;
    }
    if (cut.covered == 0) return Outcome::circle_is_free;
    // The circle is free, and whole cycles are in its cap: each earlier cap is in p's cap or disjoint from it. The caps
    // in p's cap are removed, and p waits. This occurs on scan lines, where a far point may come before a near one.
    if (!caps_.misses_circle_of(p) || !caps_.forget_within(p)) return Outcome::lost;
    boundary_.retire(cut.covered);
    boundary_.release();
    if (boundary_.live() == 0) begin();
    return Outcome::circle_is_free;
  }

  /// Step 4: cuts the arcs. Returns false if a crossing is uncertain, there is no room, or entries and exits do not
  /// match.
  bool cut_arcs(const Neighbor& p, int cap, const Cut& cut, OwnArcs& own) {
    // Most circles are crossed twice.
    constexpr std::size_t known_size = 4;
    std::array<Crossing, known_size> known;
    std::array<std::size_t, known_size> known_about;
    std::size_t known_count = 0;
    for (std::uint64_t left = cut.arcs(); left != 0; left &= left - 1) {
      const int a = std::countr_zero(left);
      const std::size_t q = boundary_.about(a);
      std::size_t at = 0;
      while (at < known_count && known_about[at] != q) ++at;
      if (at == known_count) {
        if (known_count == known_size)
          at = 0;
        else
          ++known_count;
        known[at] = crossing_of(p, caps_[q], radius_);
        known_about[at] = q;
        if (!known[at].is_certain) return false;
      }
      if (!cut_arc(a, cap, known[at], cut, own)) return false;
    }
    return own.entry_count == own.exit_count;
  }

  /// Cuts the arc from corner a where p's circle crosses it. The remaining part begins at an exit, ends at an entry, or
  /// both. Returns false if there is no room.
  bool cut_arc(int a, int cap, const Crossing& crossing, const Cut& cut, OwnArcs& own) {
    const std::uint64_t arc = std::uint64_t{1} << a;
    const int b = boundary_.next(a);
    const std::size_t about = boundary_.about(a);
    const Neighbor& q = caps_[about];
    const bool enters = cut.enters(arc), leaves = cut.leaves(arc);
    int entry = none, exit = none;
    if (enters && (entry = boundary_.add(static_cast<std::size_t>(cap), static_cast<int>(about), crossing.left,
                                         crossing.error)) == none)
      return false;
    if (leaves && (exit = boundary_.add(about, cap, crossing.right, crossing.error)) == none) return false;
    if ((cut.spared & arc) != 0) {
      boundary_.link(exit, entry, q);
    } else {
      if (leaves) boundary_.link(exit, b, q);
      if (enters) boundary_.link(a, entry, q);
    }
    if (enters) own.entries[own.entry_count++] = entry;
    if (leaves) own.exits[own.exit_count++] = exit;
    return true;
  }

  /// Step 5: closes the boundary. Returns false if the order along p's circle is not certain, or there is no room.
  bool close(const Neighbor& p, const OwnArcs& own) {
    if (own.entry_count != 1)
      return boundary_.link_around(p, {own.entries.data(), own.entry_count}, {own.exits.data(), own.exit_count});
    boundary_.link(own.entries[0], own.exits[0], p);
    return boundary_.subdivide(own.entries[0], p);
  }

  /// Handles a point p whose circle is free as a whole; the circle stays free unless another one crosses it. If a
  /// waiting circle crosses it, the two begin a cycle; if a waiting cap contains p's cap, nothing changes; otherwise p
  /// waits as well. Returns false when the region is lost.
  template <typename IsInBall>
  bool await_crossing(const Neighbor& p, IsInBall is_in_ball) {
    const double size = p.size();
    for (std::size_t i = 0; i < waiting_.count(); ++i) {
      const Neighbor q = waiting_[i];
      const CircleDepths of_p = depths_on_circle(q, q.size(), p, radius_), of_q = depths_on_circle(p, size, q, radius_);
      // If a cap contains a whole circle, it contains that circle's cap too: both are less than half of the sphere.
      if (of_p.least > of_p.error) return true;
      if (of_q.least > of_q.error) {
        waiting_.remove(i--);
        continue;
      }
      const Crossing both = crossing_of(p, q, radius_);
      if (both.is_impossible) continue;
      waiting_.remove(i);
      const Outcome outcome = cut(q, is_in_ball);  // the region may have changed since q was tried
      if (outcome == Outcome::lost) return false;
      if (outcome == Outcome::done) return subtract(p, is_in_ball);
      return begin_cycle(p, q, both) && retry_waiting(is_in_ball);
    }
    return waiting_.add(p);
  }

  /// Begins a cycle of two corners and two arcs where the free circles of p and q cross. Returns false when the region
  /// is lost.
  bool begin_cycle(const Neighbor& p, const Neighbor& q, const Crossing& both) {
    if (!both.is_certain || !caps_.misses(both.left, both.error) || !caps_.misses(both.right, both.error) ||
        caps_.count() + 2 > CapUnion::most)
      return false;
    const std::size_t first = caps_.count();
    caps_.push(p);
    caps_.push(q);
    const int a = boundary_.add(first, static_cast<int>(first) + 1, both.left, both.error),
              b = a == none ? none : boundary_.add(first + 1, static_cast<int>(first), both.right, both.error);
    if (b == none) return false;
    boundary_.link(a, b, p);
    boundary_.link(b, a, q);
    has_begun_ = true;
    return boundary_.subdivide(a, p) && boundary_.subdivide(b, q);
  }

  /// Tries the caps of waiting points q with is_wanted(q) again, nearest first. Returns false when the region is lost.
  template <typename IsInBall, typename IsWanted>
  bool retry_waiting(IsInBall is_in_ball, IsWanted is_wanted) {
    for (std::size_t i = 0; i < waiting_.count();) {
      const Outcome outcome = is_wanted(waiting_[i]) ? cut(waiting_[i], is_in_ball) : Outcome::circle_is_free;
      if (outcome == Outcome::lost) return false;
      if (outcome == Outcome::done)
        waiting_.remove(i);
      else
        ++i;
    }
    return true;
  }
  template <typename IsInBall>
  bool retry_waiting(IsInBall is_in_ball) {
    return retry_waiting(is_in_ball, [](const Neighbor&) { return true; });
  }

  double radius_ = 0;
  bool has_begun_ = false;  // whether the region has had corners
  bool is_parted_ = false;  // whether the caps cover a great circle: each part is then on one side of a plane through v
  InitialRegion initial_;
  CapUnion caps_;
  RegionBoundary boundary_;
  WaitingCircles waiting_;
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
