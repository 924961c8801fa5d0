// What: the 4^depth squares into which `depth` cuts into quarters divide a square, and the number of points in each.
// Law:  the squares result from repeated cuts in the middle, rounded; a point on a cut belongs to the square above or
//       right of the cut.
// Cost: a few nanoseconds a point.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/point.h"

namespace rbpa {

template <typename Real>
struct Square {
  Real x, y;  ///< the lower left corner
  Real side;

  Real middle_x() const { return x + side / 2; }
  Real middle_y() const { return y + side / 2; }
  /// Returns whether the square can be cut into quarters: the rounded middle is not on the lower or left side.
  bool can_be_cut() const { return middle_x() > x && middle_y() > y; }
};

template <typename Real>
class EqualSquares {
 public:
  EqualSquares(const Square<Real>& square, int depth)
      : depth_(depth), columns_(square.x, square.side, depth), rows_(square.y, square.side, depth) {
    side_ = square.side;
    for (int i = 0; i < depth; ++i) side_ /= 2;
  }

  /// Returns whether all squares remain distinct when their sides are rounded, and count() can find them without
  /// overflow.
  bool are_apart() const { return columns_.are_apart() && rows_.are_apart(); }

  /// Counts the points in each square. Requires: are_apart(), and points in the whole square.
  void count(std::span<const Point> points) {
    held_.assign(std::size_t{1} << 2 * depth_, 0);
    square_of_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) ++held_[square_of_[i] = number(points[i])];
  }

  std::size_t max_held() const { return *std::max_element(held_.begin(), held_.end()); }

  /// Calls visit(std::span<Point>, Square) for every square that holds more than `bound` points, with the points of
  /// that square.
  /// Requires: `points` are those that were counted.
  template <typename Visit>
  void for_each_above(std::size_t bound, std::span<const Point> points, Visit visit) const {
    std::vector<std::uint32_t> end(held_.size());  // for each square above the bound, the end of its points in `sorted`
    std::uint32_t size = 0;
    for (std::size_t i = 0; i < held_.size(); ++i) {
      end[i] = size;
      if (held_[i] > bound) size += held_[i];
    }
    meshops::FreshVector<Point> sorted(size);
    for (std::size_t p = 0; p < points.size(); ++p)
      if (const std::uint32_t i = square_of_[p]; held_[i] > bound) sorted[end[i]++] = points[p];
    for (std::size_t i = 0; i < held_.size(); ++i) {
      if (held_[i] <= bound) continue;
      const std::size_t column = i & ((std::size_t{1} << depth_) - 1), row = i >> depth_;
      visit(std::span(sorted).subspan(end[i] - held_[i], held_[i]), Square<Real>{columns_[column], rows_[row], side_});
    }
  }

  /// Merges the counts of quarters into counts of the squares from which the quarters were cut. Requires: a depth above
  /// 0; afterwards only max_held() and merge() may be called.
  void merge() {
    const std::size_t columns = std::size_t{1} << depth_--;
    std::vector<std::uint32_t> merged(held_.size() / 4);
    for (std::size_t i = 0; i < held_.size(); ++i)
      merged[i / columns / 2 * (columns / 2) + i % columns / 2] += held_[i];
    held_.swap(merged);
  }

 private:
  /// The bounds of the squares along one axis.
  class Cuts {
   public:
    Cuts(Real low, Real side, int depth) : at_((std::size_t{1} << depth) + 1), low_(low) {
      const std::size_t intervals = at_.size() - 1;
      per_unit_ = static_cast<Real>(intervals) / side;
      at_.front() = low;
      at_.back() = std::numeric_limits<Real>::infinity();
      for (std::size_t step = intervals; step > 1; step /= 2, side /= 2)
        for (std::size_t i = 0; i < intervals; i += step) at_[i + step / 2] = at_[i] + side / 2;
    }

    Real operator[](std::size_t interval) const { return at_[interval]; }

    bool are_apart() const {
      return std::isfinite(per_unit_) &&
             std::adjacent_find(at_.begin(), at_.end(), std::greater_equal<>()) == at_.end();
    }

    /// Returns the interval that contains a value. Requires: low ≤ value ≤ low + side.
    std::size_t interval_of(Real value) const {
      auto i = std::min(static_cast<std::size_t>((value - low_) * per_unit_), at_.size() - 2);
      while (value < at_[i]) --i;
      while (value >= at_[i + 1]) ++i;
      return i;
    }

   private:
    std::vector<Real> at_;
    Real low_, per_unit_;
  };

  std::uint32_t number(const Point& p) const {
    return static_cast<std::uint32_t>(rows_.interval_of(Real(p.y)) << depth_ | columns_.interval_of(Real(p.x)));
  }

  int depth_;
  Real side_;
  Cuts columns_, rows_;
  std::vector<std::uint32_t> held_;
  meshops::FreshVector<std::uint32_t> square_of_;  // for each counted point, its square
};

}  // namespace rbpa
