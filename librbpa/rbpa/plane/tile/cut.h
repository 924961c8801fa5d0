// What: cuts the plane into tiles along the cells of the point grid.
// Law:  every site of the grid is owned by one tile; a tile has every point of its box, except those in cells that it
//       lists as unknown.
// Cost: linear in the points of the tile and the cells of its block.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/plane/grid/hidden_points.h"
#include "rbpa/plane/grid/point_grid.h"
#include "rbpa/plane/tile/tile.h"

namespace rbpa {

/// A rectangle of cells of one level of the point grid. One tile owns the points in these cells, except the points in
/// each cell that is a grid of its own and has more than `merged` points. `points` is the number of owned points.
struct Block {
  std::uint32_t level;
  int column, row, columns, rows;
  std::uint32_t points, merged;
};

/// Returns blocks that together have every point. Each block has at least one point, and at most `max_points` unless it
/// is a single cell.
std::vector<Block> blocks(const PointGrid& grid, std::uint32_t max_points);

/// A cutter of tiles from a grid, one after another in the same memory.
class Cutter {
 public:
  /// Keeps references to both arguments. A tile lists cells with hidden points as unknown; Tile::nothing_left to
  /// nothing_above count hidden points.
  explicit Cutter(const PointGrid& grid, const HiddenPoints& hidden = none_hidden()) : grid_(grid), hidden_(hidden) {}

  /// Replaces `tile` by the tile of a block: its points, and the ghosts around them. The tile is empty if the block has
  /// more points than a tile can have.
  void cut(const Block& block, Tile& tile);

 private:
  using Level = PointGrid::Level;

  void lay_cells(const Level& level, const Block& block, Tile& tile);
  void gather(const Level& level, const Block& block, Tile& tile);
  void gather_beyond(const Level& level, const Tile& tile);
  void forget_hidden(const Level& level, const Tile& tile);
  void add(std::uint32_t first, std::uint32_t last);
  void forget(const Tile& tile, double x_low, double x_high, double y_low, double y_high);
  void sort_into_cells(Tile& tile);

  const PointGrid& grid_;
  const HiddenPoints& hidden_;
  struct Range {
    std::uint32_t first, last;
  };
  std::vector<Range> sites_;
  std::size_t owned_ = 0, all_ = 0;  // numbers of points; the owned ones come first
  std::vector<std::uint32_t> cell_of_, count_;
  std::vector<std::uint8_t> unknown_;
  bool any_unknown_ = false;
};

}  // namespace rbpa
