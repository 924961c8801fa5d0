// What: the density of points: a count for each square of a grid, whose side is a power of two that grows with the
//       input.
// Law:  the counts add up to the points; no coordinate is too large or too small. They choose tiles and decide nothing.
// Cost: a hash table access a point, less where points follow each other; memory as the most cells that are allowed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// A square with points in it, whose corners are multiples of the side.
struct Cell {
  std::int64_t column = 0, row = 0;
  std::uint64_t count = 0;
};

class CellCounts {
 public:
  /// With at most so many cells.
  explicit CellCounts(std::size_t most);

  /// Requires finite points.
  void add(std::span<const Point> points);

  std::vector<Cell> cells() const;  ///< by column, then by row
  double side() const;
  std::uint64_t points() const { return points_; }
  const Point& least() const { return least_; }        ///< of the bounding box; zero without points
  const Point& greatest() const { return greatest_; }  ///< likewise

 private:
  void begin();
  void add(std::int64_t column, std::int64_t row, std::uint64_t count);
  void grow_side(int doublings);
  void rebuild(std::size_t size, int doublings);
  Cell* find(std::int64_t column, std::int64_t row);

  std::size_t most_;
  std::size_t used_ = 0;
  std::vector<Cell> table_;  // open addressing, at most half of it used; count 0: free
  int exponent_ = 0;         // of the side
  std::uint64_t points_ = 0;
  Point least_ = {}, greatest_ = {};
};

}  // namespace rbpa::app
