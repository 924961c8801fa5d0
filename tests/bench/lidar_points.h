// What: points as a survey of the ground has them, row by row, made on demand: map coordinates in whole
//       hundredths, lakes with an island each, gaps as houses leave them.
// Law:  a function of the set, the number of points and the seed; any part of them can be made again.
// Cost: a few hashes a point; nothing is kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa_bench {

enum class Ground {
  jittered,  ///< one point in each square of side 1, moved by up to 0.45 either way; neighbors follow each other
  uniform    ///< as many points anywhere in each strip of height 1, in any order
};

class LidarPoints {
 public:
  /// `count` points, of mean spacing 1 where they are, in about a square.
  LidarPoints(Ground ground, std::uint64_t count, std::uint64_t seed);

  /// Replaces `block` by the next points, at most so many; false at the end.
  bool next(std::vector<rbpa::Point>& block, std::size_t most);

  /// Squares of side 1: columns from column to last_column, rows likewise, the last not included.
  struct Squares {
    std::int64_t column, row, last_column, last_row;
  };
  /// The points of these squares of jittered ground without end, wherever next() is, each with the number of its square.
  /// Requires numbers from 0 to 2³¹.
  void in_squares(const Squares& squares, std::vector<rbpa::Point>& points, std::vector<std::uint64_t>& indices);
  /// The lower left corner of a square, which is of no square beside it.
  static rbpa::Point corner_of(std::int64_t column, std::int64_t row);

 private:
  struct Disk {
    std::int64_t x = 0, y = 0, radius = 0;  // hundredths
    bool contains(std::int64_t px, std::int64_t py) const {
      return (px - x) * (px - x) + (py - y) * (py - y) < radius * radius;
    }
  };

  /// The place in a square, in hundredths.
  struct Spot {
    std::int64_t x, y;
  };
  Spot jittered(std::int64_t column, std::int64_t row) const;
  void make_row();
  std::uint64_t hash(std::uint64_t kind, std::int64_t column, std::int64_t row) const;
  bool is_ground(std::int64_t x, std::int64_t y);
  void look_at_square(std::int64_t column, std::int64_t row);

  Ground ground_;
  std::uint64_t left_, seed_;
  std::int64_t columns_, row_ = 0;
  Disk gap_, lake_, island_;
  std::int64_t square_column_ = -1, square_row_ = -1;  // of which the disks are
  std::vector<rbpa::Point> waiting_;                   // of a row
  std::size_t taken_ = 0;
};

}  // namespace rbpa_bench
