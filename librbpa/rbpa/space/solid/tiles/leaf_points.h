// What: gathers the points of a leaf and the points around the leaf in cells of one grid: enough points to find the
//       tetrahedra at the leaf's points, except tetrahedra with large balls.
// Law:  a point is in the tile exactly if its cell is among the tile's cells; a point of the leaf that is far from most
//       others may be outside of the tile. Points are in the order of cells.
// Cost: some nanoseconds for each point visited, three times as many as the leaf has if points are spread evenly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/space/solid/tiles/leaves.h"

namespace rbpa::space {

class Tile {
 public:
  /// A position among the tile's points.
  using Local = std::uint32_t;
  static constexpr std::size_t most_points = 1u << 16;  ///< so that a Local fits 16 bits
  /// Number of layers of cells around those of the leaf.
  static constexpr int margin = 3;

  /// Replaces the points of the tile by the points in and around leaf number `leaf`. Returns false, with an empty tile,
  /// if there are more than most_points, or the cells are too small for the precision of coordinates.
  bool gather(const Leaves& leaves, std::size_t leaf);

  std::size_t size() const { return size_; }
  double x(Local i) const { return x_[i]; }
  double y(Local i) const { return y_[i]; }
  double z(Local i) const { return z_[i]; }
  /// Returns the array of a coordinate of all points, readable up to one register beyond its end.
  const double* x() const { return x_.data(); }
  const double* y() const { return y_.data(); }
  const double* z() const { return z_.data(); }
  Place place(Local i) const { return place_[i]; }
  bool is_own(Local i) const { return place_[i] - first_own_ < own_; }
  Place first_own() const { return first_own_; }

  /// Returns the number of cells along each axis. Cells are numbered from 0; consecutive cells are neighbors along z.
  const std::array<int, 3>& cells() const { return cells_; }
  std::size_t cell(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(cells_[2]) +
           static_cast<std::size_t>(z);
  }
  Local first_in(std::size_t cell) const { return start_[cell]; }

  /// A range of cells along an axis, `low` and `high` included; empty if low > high.
  struct Range {
    int low, high;
  };
  /// Sets `of` to the cells of the tile that `box` meets and that may contain points. Returns false if `box` also meets
  /// cells outside of the tile that may contain points.
  bool ranges(const Box& box, std::array<Range, 3>& of) const;

 private:
  CellGrid grid_;
  std::array<int, 3> cells_{};
  std::array<Range, 3> filled_{};  // the cells that the bounding box of all leaves meets
  std::size_t size_ = 0;
  Place first_own_ = 0;
  std::size_t own_ = 0;
  std::vector<double> x_, y_, z_;
  std::vector<Place> place_;
  std::vector<Local> start_;
  // The points and their cells, before sorting.
  std::vector<Place> unsorted_;
  std::vector<std::uint32_t> cell_of_;
};

}  // namespace rbpa::space
