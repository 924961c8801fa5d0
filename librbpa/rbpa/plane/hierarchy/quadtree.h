// What:   the leaves of a quadtree over points, which measure their density.
// Law:    a square with more than `capacity` distinct points is cut into quarters. The root is the least square that
//         begins at the lower left corner of the points' box and covers the box. The leaves are a function of the set
//         of points.
// Cost:   linear in the points if they lie evenly; otherwise at most proportional to points times depth. Nested
//         squares that each have all their points in one quarter cost together as much as one square.
// Source: Restricted BPA, section 6, "Minimal radius estimation".
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/grid/box.h"
#include "rbpa/plane/hierarchy/equal_squares.h"

namespace rbpa {

template <typename Real>
class Quadtree {
 public:
  /// Keeps the span. Requires: finite, distinct points.
  Quadtree(std::span<const Point> points, std::size_t capacity)
      : points_(points), capacity_(std::max<std::size_t>(capacity, 1)) {}

  /// Returns the side of the smallest leaf, or of the root if the root is not cut; 0 without points. Calls
  /// `checkpoint`, if any, repeatedly while squares have more than 4,096 points; `checkpoint` may throw.
  Real smallest_side(const Checkpoint& checkpoint = {}) const {
    if (points_.empty()) return 0;
    const auto [low, high] = box_of(points_);
    const Square<Real> root{Real(low.x), Real(low.y), std::max(Real(high.x) - Real(low.x), Real(high.y) - Real(low.y))};
    if (points_.size() > many) return smallest_in(points_, root, checkpoint);
    std::vector<Point> points(points_.begin(), points_.end());
    return smallest_one_by_one(points, root, checkpoint);
  }

 private:
  static constexpr std::size_t many = 4096;  ///< number of points from which counting pays

  /// Returns the smallest square of the tree within `square` that holds all of `points`, from the points' box alone.
  Square<Real> around(std::span<const Point> points, Square<Real> square) const {
    const auto [low, high] = box_of(points);
    while (square.can_be_cut()) {
      const Real x = square.middle_x(), y = square.middle_y();
      const bool in_right = Real(low.x) >= x, in_left = Real(high.x) < x, in_top = Real(low.y) >= y,
                 in_bottom = Real(high.y) < y;
      if (!(in_right || in_left) || !(in_top || in_bottom)) break;
      square = {in_right ? x : square.x, in_top ? y : square.y, square.side / 2};
    }
    return square;
  }

  /// Returns the side of the smallest leaf in a square.
  Real smallest_in(std::span<const Point> points, Square<Real> square, const Checkpoint& checkpoint) const {
    if (checkpoint) checkpoint();
    if (points.size() <= capacity_) return square.side;
    square = around(points, square);
    // The depth is such that evenly spaced points need no further cut, and that the counts stay in a cache.
    int depth = 1;
    while (depth < 8 && (capacity_ << 2 * depth) < 16 * points.size()) ++depth;
    EqualSquares<Real> squares(square, depth);
    if (!squares.are_apart()) {
      std::vector<Point> copy(points.begin(), points.end());
      return smallest_one_by_one(copy, square, checkpoint);
    }
    squares.count(points);
    Real least = square.side;
    if (squares.max_held() > capacity_) {
      squares.for_each_above(capacity_, points, [&](std::span<Point> held, const Square<Real>& s) {
        least = std::min(
            least, held.size() > many ? smallest_in(held, s, checkpoint) : smallest_one_by_one(held, s, checkpoint));
      });
      return least;
    }
    for (; squares.max_held() <= capacity_; --depth) squares.merge();
    for (; depth >= 0; --depth) least /= 2;
    return least;
  }

  /// Returns the side of the smallest leaf in a square, cutting one square after another.
  Real smallest_one_by_one(std::span<Point> points, Square<Real> square, const Checkpoint& checkpoint) const {
    if (points.size() <= capacity_) return square.side;
    if (checkpoint && points.size() > many) checkpoint();
    square = around(points, square);
    if (!square.can_be_cut()) return square.side;
    const Real x = square.middle_x(), y = square.middle_y(), half = square.side / 2;
    const auto part = [&](std::span<Point> all, auto in_first) {
      const auto end = std::partition(all.begin(), all.end(), in_first);
      return static_cast<std::size_t>(end - all.begin());
    };
    Real least = half;
    const std::size_t middle = part(points, [&](const Point& p) { return Real(p.y) < y; });
    for (const bool above : {false, true}) {
      const auto row = above ? points.subspan(middle) : points.first(middle);
      const std::size_t left = part(row, [&](const Point& p) { return Real(p.x) < x; });
      const Real low = above ? y : square.y;
      least = std::min(least, smallest_one_by_one(row.first(left), {square.x, low, half}, checkpoint));
      least = std::min(least, smallest_one_by_one(row.subspan(left), {x, low, half}, checkpoint));
    }
    return least;
  }

  std::span<const Point> points_;
  std::size_t capacity_;
};

}  // namespace rbpa
