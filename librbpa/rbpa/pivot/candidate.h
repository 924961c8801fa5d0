// What:   the contest between the points that a ball pivoting on an edge may touch first.
// Law:    after any points were considered in any order, best() is the one left of a→b whose (perturbed) circle with a
//         and b contains none of the others: the one that subtends the largest angle.
// Why:    with e = p − a, f = p − b, the circle's centre lies k = (e · f) / (ab × e) half-chords left of the chord's
//         midpoint, so that the least k wins. Each k is computed with bounds, without a branch; nearly always one
//         upper bound is below all other lower bounds, and only the others' owners need exact arithmetic.
// Source: Restricted BPA, section 3.2 and figure 3.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "rbpa/pivot/lanes.h"
#include "rbpa/predicate/predicates.h"

namespace rbpa {

template <typename Real>
class Candidates {
 public:
  using P = Predicates<Real>;
  using Site = std::uint32_t;

  /// `points` must be followed by `padding` more, of any value.
  /// `grid_unit`: a power of two of which all coordinates are multiples, or 0 when that is of no use.
  Candidates(const Point* points, Site a, Site b, Real grid_unit)
      : points_(points),
        a_(points[a]),
        b_(points[b]),
        site_a_(a),
        site_b_(b),
        d_(P::from(a_, b_)),
        grid_unit_(grid_unit) {}

  static constexpr std::size_t copied = 8;  ///< points at a time
  static constexpr std::size_t padding = copied - 1;

  const Point& a() const { return a_; }
  const Point& b() const { return b_; }
  Site site_a() const { return site_a_; }
  Site site_b() const { return site_b_; }
  const typename P::Vector& chord() const { return d_; }

  /// Tells of a site that will be considered: what has a circle beyond its own is out of the contest at once.
  void expect(Site i) {
    Real low, high;
    bounds(a_, b_, d_, Real(points_[i].x), Real(points_[i].y), low, high);
    least_high_ = std::min(least_high_, high);
  }

  void consider(Site first, Site last) {
    while (first < last) {
      if (size_ + copied > capacity) settle();
      // A fixed number is copied, so that the copy has no loop to be mispredicted; the next overwrites what is too
      // much.
      const Site count = std::min(last - first, static_cast<Site>(copied));
      const Point* const point = points_ + first;
      for (std::size_t i = 0; i < copied; ++i) {
        x_[size_ + i] = Real(point[i].x);
        y_[size_ + i] = Real(point[i].y);
        site_[size_ + i] = first + static_cast<Site>(i);
      }
      slot_of_a_ = site_a_ - first < count ? size_ + (site_a_ - first) : slot_of_a_;
      slot_of_b_ = site_b_ - first < count ? size_ + (site_b_ - first) : slot_of_b_;
      size_ += count;
      first += count;
      settled_ = false;
    }
  }

  /// The winner of all that were considered.
  std::optional<Site> best() {
    settle();
    return size_ == 0 ? std::nullopt : std::optional(site_[0]);
  }

  /// Leaves the winner of all that were considered as the only one, and brings centre_bound() up to date.
  void settle() {
    if (settled_) return;
    settled_ = true;
    evaluate();
    using Mask = typename L::Mask;
    Mask in_it = Mask{} + 0, winner = Mask{} - 1, position = L::positions();
    const auto least = L::all(least_high_);
    for (std::size_t i = 0; i < size_; i += step) {
      const Mask can_win = L::less_equal(L::load(&low_[i]), least);
      in_it -= can_win;
      winner = L::select_mask(can_win, position, winner);
      position += static_cast<std::int64_t>(step);
    }
    const auto i = static_cast<std::size_t>(L::greatest(winner));
    if (L::sum(in_it) == 1 && std::isfinite(low_[i]))
      keep(i);
    else
      settle_exactly();
  }

  /// At most this many half-chords left of the midpoint is the centre of the best circle; infinity when there is no
  /// best or its numbers say nothing.
  Real centre_bound() const { return least_high_; }

 private:
  using L = Lanes<Real>;
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();
  static constexpr std::size_t step = L::width;
  static constexpr std::size_t capacity = 64;

  /// k of points between two bounds each. A point right of the chord is out of it (low = ∞); one too near the chord's
  /// line to say is undecided (−∞, ∞).
  template <typename Value>
  static void bounds(const Point& a, const Point& b, const typename P::Vector& d, const Value& x, const Value& y,
                     Value& low, Value& high) {
    const auto size = [](const Value& v) {
      if constexpr (std::is_same_v<Value, Real>)
        return std::abs(v);
      else
        return L::size(v);
    };
    const Value ex = x - Real(a.x), ey = y - Real(a.y), fx = x - Real(b.x), fy = y - Real(b.y);
    const Value c1 = d.x * ey, c2 = d.y * ex, d1 = ex * fx, d2 = ey * fy;
    const Value cross = c1 - c2, cross_size = size(c1) + size(c2);
    const Value dot = d1 + d2, dot_size = size(d1) + size(d2);
    const Value inverse = 1 / cross;
    const Value k = dot * inverse;
    const Value error = 8 * P::unit * (dot_size + size(k) * cross_size) * inverse;
    const Value out = Value{} + infinity;
    const auto left = cross > 64 * P::unit * cross_size;
    const auto right = cross < -5 * P::unit * cross_size;
    low = left ? k - error : right ? out : -out;
    high = left ? k + error : out;
  }

  void evaluate() {
    for (std::size_t i = size_; i % step != 0; ++i) {
      x_[i] = Real(a_.x);  // up to a whole step, a point that cannot win
      y_[i] = Real(a_.y);
    }
    // Copies: what is stored below might, for all the compiler knows, change the members.
    const Point a = a_, b = b_;
    const typename P::Vector d = d_;
    const std::size_t size = size_;
    auto least = L::all(least_high_);
    for (std::size_t i = 0; i < size; i += step) {
      typename L::Value low, high;
      bounds(a, b, d, L::load(&x_[i]), L::load(&y_[i]), low, high);
      L::store(&low_[i], low);
      least = L::select(L::less_equal(high, least), high, least);
    }
    least_high_ = L::least(least);
    // The ends of the chord, and what fills the last step, are no candidates.
    low_[slot_of_a_] = low_[slot_of_b_] = infinity;
    for (std::size_t i = size_; i % step != 0; ++i) low_[i] = infinity;
    slot_of_a_ = slot_of_b_ = capacity;
  }

  void keep(std::size_t winner) {
    x_[0] = x_[winner];
    y_[0] = y_[winner];
    low_[0] = low_[winner];
    site_[0] = site_[winner];
    size_ = 1;
  }

  /// What the bounds left undecided.
  void settle_exactly() {
    std::size_t winner = size_;
    for (std::size_t i = 0; i < size_; ++i) {
      if (low_[i] > least_high_ || low_[i] == infinity) continue;
      const Point& p = points_[site_[i]];
      if (low_[i] == -infinity && !is_left(p)) continue;
      // A wider search meets the points of a narrower one again.
      if (winner == size_ || (site_[i] != site_[winner] && beats(p, points_[site_[winner]]))) winner = i;
    }
    if (winner == size_)
      size_ = 0;
    else
      keep(winner);
  }

  bool is_left(const Point& p) const {
    // Points in line with the chord are many on grids; small multiples of a common unit have an exact cross product.
    const auto e = P::from(a_, p);
    if (std::max(reach(e), reach(d_)) <= grid_unit_ * exact_cross_reach) return P::cross(d_, e) > 0;
    return P::orientation(a_, b_, p) > 0;
  }

  static Real reach(const typename P::Vector& v) { return std::max(std::abs(v.x), std::abs(v.y)); }

  /// Is q, left of the chord like p, inside the perturbed circle of p?
  bool beats(const Point& q, const Point& p) const {
    // Small multiples of a common unit, as on grids, make every operation here exact.
    const auto e = P::from(a_, p), f = P::from(b_, p), g = P::from(a_, q), h = P::from(b_, q);
    if (std::max({reach(e), reach(f), reach(g), reach(h), reach(d_)}) <= grid_unit_ * exact_reach) {
      const Real worse = P::dot(g, h) * P::cross(d_, e) - P::dot(e, f) * P::cross(d_, g);
      return worse == 0 ? P::perturbed_side(a_, b_, p, q) > 0 : worse < 0;
    }
    return P::in_perturbed_circle(a_, b_, p, q) > 0;
  }

  /// In such units, dot and cross products are at most 2 · 2^24, and differences of their products below 2^52.
  static constexpr Real exact_reach = 4096;
  static constexpr Real exact_cross_reach = 0x1p+25;

  const Point* points_;
  Point a_, b_;
  Site site_a_, site_b_;
  typename P::Vector d_;
  Real grid_unit_;
  Real least_high_ = infinity;
  std::size_t size_ = 0;
  bool settled_ = true;
  std::size_t slot_of_a_ = capacity, slot_of_b_ = capacity;
  std::array<Real, capacity> x_, y_;
  std::array<Real, capacity + 1> low_;  // and one that nobody reads
  std::array<Site, capacity> site_;
};

}  // namespace rbpa
