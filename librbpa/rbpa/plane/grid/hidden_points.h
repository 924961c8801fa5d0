// What: points that are not in a grid, with their places, for searches that must not miss them.
// Law:  in_box() reports every hidden point of a box. are_left(), are_right(), are_below() and are_above() report every
//       side of the grid's box on which a hidden point lies outside of the box, or on its border.
#pragma once

#include <span>

#include "rbpa/plane/grid/box.h"
#include "rbpa/plane/grid/point_grid.h"

namespace rbpa {

class HiddenPoints {
 public:
  /// Constructs an empty set of hidden points.
  HiddenPoints() = default;
  /// Copies the places of the hidden points; `box` is the grid's box. Places may lie outside of the box, and may be
  /// rounded by amounts that are negligible against a cell.
  HiddenPoints(std::span<const Point> places, const Box& box) : places_(places) {
    for (const Point& p : places) {
      left_ |= p.x <= box.low.x;
      right_ |= p.x >= box.high.x;
      below_ |= p.y <= box.low.y;
      above_ |= p.y >= box.high.y;
    }
  }

  bool none() const { return places_.points().empty(); }
  bool are_left() const { return left_; }
  bool are_right() const { return right_; }
  bool are_below() const { return below_; }
  bool are_above() const { return above_; }

  /// Calls visit(place) for all hidden points in a box, and for some near the box.
  template <typename Visit>
  void in_box(const Box& box, Visit visit) const {
    places_.scan(box, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t i = first; i < last; ++i) visit(places_.points()[i]);
    });
  }

 private:
  PointGrid places_{std::span<const Point>()};
  bool left_ = false, right_ = false, below_ = false, above_ = false;
};

inline const HiddenPoints& none_hidden() {
  static const HiddenPoints none;
  return none;
}

}  // namespace rbpa
