// What: counts points in the squares of a grid. The side of a square is a power of two that grows with the extent of
//       the points.
// Law:  the counts add up to the number of points, for any finite coordinates. Counts choose tiles; they do not affect
//       the result.
// Cost: one access of a hash table for each point, fewer if successive points are in one square; memory for `most`
//       cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// A square with points, and their number. The coordinates of the corners of the square are multiples of its side.
struct Cell {
  std::int64_t column = 0, row = 0;
  std::uint64_t count = 0;
};

class CellCounts {
 public:
  /// Prepares counting in at most `most` cells. The side of the cells doubles whenever more cells would be needed.
  explicit CellCounts(std::size_t most);

  /// Counts the points. Requires: finite coordinates.
  void add(std::span<const Point> points);

  std::vector<Cell> cells() const;  ///< the cells that contain points, sorted by column, then by row
  double side() const;
  std::uint64_t points() const { return points_; }
  const Point& least() const { return least_; }        ///< least coordinates of all points; (0, 0) without points
  const Point& greatest() const { return greatest_; }  ///< greatest coordinates of all points; (0, 0) without points

 private:
  void begin();
  void add(std::int64_t column, std::int64_t row, std::uint64_t count);
  void grow_side(int doublings);
  void rebuild(std::size_t size, int doublings);
  Cell* find(std::int64_t column, std::int64_t row);

  std::size_t most_;
  std::size_t used_ = 0;
  std::vector<Cell> table_;  // open addressing, at most half full; a free entry has count 0
  int exponent_ = 0;         // the side is 2^exponent_
  std::uint64_t points_ = 0;
  Point least_ = {}, greatest_ = {};
};

}  // namespace rbpa::app
