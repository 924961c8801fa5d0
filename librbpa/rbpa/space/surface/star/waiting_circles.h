// What: keeps the points whose circles are free as a whole. A free circle bounds the free region but has no corner; its
//       cap is not subtracted yet.
// Law:  no two of the circles cross, and no cap is inside another. The nearest point is first.
#pragma once

#include <array>
#include <cstddef>

#include "rbpa/space/surface/star/neighbor.h"

namespace rbpa::space {

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
