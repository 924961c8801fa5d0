// What:   the leaves of a quadtree over points, which tell how dense they lie.
// Law:    a square with more than `capacity` distinct points is cut in four, the first is the least square that begins
//         at the lower left corner of the points' box and covers it. A function of the set of points.
// Cost:   linear in points times depth; a square whose points all lie in one small part of it costs no more than one.
// Source: Restricted BPA, section 6, "Minimal radius estimation".
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/core/point.h"

namespace rbpa {

template <typename Real>
class Quadtree {
 public:
  struct Square {
    Real x, y;  ///< the lower left corner
    Real side;
  };

  /// Requires: finite, distinct points.
  Quadtree(std::span<const Point> points, std::size_t capacity)
      : points_(points.begin(), points.end()), capacity_(std::max<std::size_t>(capacity, 1)) {
    if (points.empty()) return;
    const Box box = box_of(points_);
    root_ = {box.x, box.y, std::max(box.width, box.height)};
  }

  /// The side of the smallest leaf; of the root when that is the only one.
  Real smallest_side() {
    Real least = root_.side;
    for_each_cut([&](const Square& parent) { least = std::min(least, parent.side / 2); });
    return least;
  }

  /// Calls visit(Square) for every square that is cut. A square that holds points in one quarter only is not visited
  /// for itself: what is cut there lies in that quarter. The last of them is, where the numbers end before the points
  /// part.
  template <typename Visit>
  void for_each_cut(Visit visit) {
    cut(points_, root_, visit);
  }

 private:
  struct Box {
    Real x, y, width, height;
  };

  static Box box_of(std::span<const Point> points) {
    Point low = points[0], high = low;
    for (const Point& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {Real(low.x), Real(low.y), Real(high.x) - Real(low.x), Real(high.y) - Real(low.y)};
  }

  template <typename Visit>
  void cut(std::span<Point> points, Square square, Visit visit) {
    if (points.size() <= capacity_) return;
    // Down to the last square that holds all the points, without touching them.
    const Box box = box_of(points);
    const Real right = box.x + box.width, top = box.y + box.height;
    Real x, y;  // where the square is cut
    for (Square parent = square;;) {
      x = square.x + square.side / 2;
      y = square.y + square.side / 2;
      if (!(x > square.x && y > square.y)) {  // too small for its place: the numbers end here
        if (square.side < parent.side) visit(parent);
        return;
      }
      const bool in_right = box.x >= x, in_left = right < x, in_top = box.y >= y, in_bottom = top < y;
      if (!(in_right || in_left) || !(in_top || in_bottom)) break;
      parent = square;
      square = {in_right ? x : square.x, in_top ? y : square.y, square.side / 2};
    }
    visit(square);
    const auto half = [&](std::span<Point> part, auto in_first) {
      const auto end = std::partition(part.begin(), part.end(), in_first);
      return static_cast<std::size_t>(end - part.begin());
    };
    const std::size_t middle = half(points, [&](const Point& p) { return Real(p.y) < y; });
    for (const bool above : {false, true}) {
      const auto row = above ? points.subspan(middle) : points.first(middle);
      const std::size_t left = half(row, [&](const Point& p) { return Real(p.x) < x; });
      const Real low = above ? y : square.y;
      cut(row.first(left), {square.x, low, square.side / 2}, visit);
      cut(row.subspan(left), {x, low, square.side / 2}, visit);
    }
  }

  std::vector<Point> points_;
  std::size_t capacity_;
  Square root_{0, 0, 0};
};

}  // namespace rbpa
