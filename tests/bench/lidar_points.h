// What: points as in a survey of the ground, row by row, made on demand: map coordinates in whole hundredths, lakes
//       with an island each, gaps such as houses leave.
// Law:  the points are a function of the set, the number of points and the seed.
// Cost: a few hashes per point; nothing is kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa_bench {

enum class Ground {
  jittered,  ///< one point per square of side 1, moved by up to 0.45 either way; in the order of squares
  uniform    ///< equally many points anywhere in each strip of height 1, in any order
};

class LidarPoints {
 public:
  /// Prepares `count` points in about a square, with mean spacing 1 where there are any.
  LidarPoints(Ground ground, std::uint64_t count, std::uint64_t seed);

  /// Replaces `block` by the next points, at most `most`. Returns: false at the end.
  bool next(std::vector<rbpa::Point>& block, std::size_t most);

 private:
  struct Disk {
    std::int64_t x = 0, y = 0, radius = 0;  // hundredths
    bool contains(std::int64_t px, std::int64_t py) const {
      return (px - x) * (px - x) + (py - y) * (py - y) < radius * radius;
    }
  };

  /// Place in a square, in hundredths.
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
  std::int64_t square_column_ = -1, square_row_ = -1;  // the square whose disks are stored
  std::vector<rbpa::Point> waiting_;                   // the rest of a row
  std::size_t taken_ = 0;
};

}  // namespace rbpa_bench
