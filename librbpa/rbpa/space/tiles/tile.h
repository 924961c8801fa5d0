// What: the points of a leaf and those around it, in the leaf's cells: all that is needed to find the tetrahedra at the leaf's
//       points, unless their balls are large.
// Law:  every point whose cell is within the tile's is in it, and no other: a point of the leaf that is far from most of them may be
//       outside. Points are in the order of cells.
// Cost: some nanoseconds for each point looked at; three times as many as the leaf has, where points are spread evenly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/space/tiles/leaves.h"

namespace rbpa::space {

class Tile {
 public:
  /// A position among the tile's points.
  using Local = std::uint32_t;
  static constexpr std::size_t most_points = 1u << 16;
  /// Cells around those of the leaf.
  static constexpr int margin = 3;

  /// Replaces the points. Returns: false if there are too many, or the cells are too small for their coordinates.
  bool gather(const Leaves& leaves, std::size_t leaf);

  std::size_t size() const { return size_; }
  double x(Local i) const { return x_[i]; }
  double y(Local i) const { return y_[i]; }
  double z(Local i) const { return z_[i]; }
  /// May be read a register beyond the end.
  const double* x() const { return x_.data(); }
  const double* y() const { return y_.data(); }
  const double* z() const { return z_.data(); }
  Place place(Local i) const { return place_[i]; }
  bool is_own(Local i) const { return place_[i] - first_own_ < own_; }
  Place first_own() const { return first_own_; }

  /// Cells are numbered from 0 along each axis, those along z being neighbors.
  const std::array<int, 3>& cells() const { return cells_; }
  std::size_t cell(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(cells_[2]) +
           static_cast<std::size_t>(z);
  }
  Local first_in(std::size_t cell) const { return start_[cell]; }

  /// The cells that a box meets, as far as there may be points: from `low` to `high` along an axis.
  struct Range {
    int low, high;
  };
  /// Returns: false if it has cells in which there may be points that are not in the tile.
  bool ranges(const Box3& box, std::array<Range, 3>& of) const;

 private:
  CellGrid grid_;
  std::array<int, 3> cells_{};
  std::array<Range, 3> filled_{};  // by the box of all points
  std::size_t size_ = 0;
  Place first_own_ = 0;
  std::size_t own_ = 0;
  std::vector<double> x_, y_, z_;
  std::vector<Place> place_;
  std::vector<Local> start_;
  // Before they are sorted.
  std::vector<Place> unsorted_;
  std::vector<std::uint32_t> cell_of_;
};

}  // namespace rbpa::space
