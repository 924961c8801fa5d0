// What: computes how deep the circle of a point, on which the centers of balls that touch it lie, reaches into the cap
//       of another point; keeps the points whose circles are free.
// Law:  depths are correct within the errors that limits.h allows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rbpa/space/surface/star/limits.h"
#include "rbpa/space/surface/star/neighbor.h"

namespace rbpa::space {

/// The extremes of the depth c · p − p²/2 for c on the circle of q, along which it is a cosine; and a bound of their
/// errors.
struct CircleDepths {
  double greatest, least, error;
};

/// Returns the extremes. Requires: `size` is p.size().
inline CircleDepths depths_on_circle(const Neighbor& p, double size, const Neighbor& q, double radius) {
  const double along = dot(p.at, q.at), qq = 2 * q.power;
  const double across = std::sqrt(std::max(0.0, 2 * p.power - along * along / qq));
  const double half_range = std::sqrt(std::max(0.0, radius * radius - qq / 4)) * across;
  return {along / 2 + half_range - p.power, along / 2 - half_range - p.power, limits::extreme * radius * size};
}

/// Points whose circles are free as a whole. A free circle bounds the free region but has no corner; its cap is not
/// subtracted yet. No two of the circles cross, and no cap is inside another. The nearest point is first.
class WaitingCircles {
 public:
  static constexpr std::size_t capacity = 64;

  void clear() { count_ = 0; }
  std::size_t count() const { return count_; }
  const Neighbor& operator[](std::size_t i) const { return points_[i]; }

  /// Adds p. Returns false where there is no room.
  bool add(const Neighbor& p) {
    if (count_ == capacity) return false;
    std::size_t at = count_++;
    for (; at > 0 && p.power < points_[at - 1].power; --at) points_[at] = points_[at - 1];
    points_[at] = p;
    return true;
  }
  void remove(std::size_t i) {
    --count_;
    for (; i < count_; ++i) points_[i] = points_[i + 1];
  }

 private:
  std::size_t count_ = 0;
  std::array<Neighbor, capacity> points_;
};

}  // namespace rbpa::space
