#include "rbpa/plane/tile/cut.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rbpa {
namespace {

using Level = PointGrid::Level;

constexpr double points_per_cell = 2;
constexpr double max_contrast = 3;         // maximum ratio of densities of the halves of a block
constexpr std::uint32_t min_points = 256;  // a smaller block is not divided for its density
constexpr double margin = 2;               // width of the halo in cells: about three times the distance of neighbors

/// Calls visit(first, last) for each row of a block, with its cells first to last − 1.
template <typename Visit>
void for_each_row(const Level& level, const Block& block, Visit visit) {
  for (int r = block.row; r < block.row + block.rows; ++r) {
    const auto first = static_cast<std::uint32_t>(r * level.columns + block.column);
    visit(first, first + static_cast<std::uint32_t>(block.columns));
  }
}

std::uint32_t points_in(const Level& level, std::uint32_t cell) { return level.start[cell + 1] - level.start[cell]; }

/// Calls visit(cell) for the cells first to last − 1 of a row that are grids of more than `merged` points, ascending.
template <typename Visit>
void for_each_grid(const Level& level, std::uint32_t merged, std::uint32_t first, std::uint32_t last, Visit visit) {
  for (auto child = level.child_at(first); child != level.children.end() && child->cell < last; ++child)
    if (points_in(level, child->cell) > merged) visit(child->cell);
}

/// Returns the maximum number of points, ghosts included, of a tile that owns `owned` points. Next to dense cells, a
/// tile leaves ghosts out.
std::size_t max_points_around(std::size_t owned) { return std::min(Tile::max_points, 8 * owned + 1024); }

std::uint32_t points_of(const Level& level, const Block& block) {
  std::uint32_t count = 0;
  for_each_row(level, block, [&](std::uint32_t first, std::uint32_t last) {
    count += level.start[last] - level.start[first];
    for_each_grid(level, block.merged, first, last, [&](std::uint32_t cell) { count -= points_in(level, cell); });
  });
  return count;
}

std::array<Block, 2> halves(const Level& level, const Block& block) {
  Block first = block, second = block;
  if (block.columns > block.rows) {
    first.columns = block.columns / 2;
    second.columns -= first.columns;
    second.column += first.columns;
  } else {
    first.rows = block.rows / 2;
    second.rows -= first.rows;
    second.row += first.rows;
  }
  first.points = points_of(level, first);
  second.points = block.points - first.points;
  return {first, second};
}

/// Returns the mean number of points in a cell of the block.
double density(const Block& block) { return block.points / (double(block.columns) * block.rows); }

/// Returns whether two blocks differ in density by at most the factor max_contrast: cells of one size then suit both.
bool is_uniform(const Block& a, const Block& b) {
  return std::max(density(a), density(b)) <= max_contrast * std::min(density(a), density(b));
}

/// Returns the mean over points of the number of points in the same cell: one more than density() if points are spread
/// evenly, far more if a few cells have most of the points.
double mean_occupancy(const Level& level, const Block& block) {
  std::uint64_t squares = 0;
  const auto square = [&](std::uint32_t cell) {
    return std::uint64_t{points_in(level, cell)} * points_in(level, cell);
  };
  for_each_row(level, block, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t cell = first; cell < last; ++cell) squares += square(cell);
    for_each_grid(level, block.merged, first, last, [&](std::uint32_t cell) { squares -= square(cell); });
  });
  return double(squares) / block.points;
}

void divide(const Level& level, const Block& block, std::uint32_t max_points, std::vector<Block>& found) {
  if (block.points == 0) return;
  if (block.columns > 1 || block.rows > 1) {
    const auto [first, second] = halves(level, block);
    if (block.points > max_points ||
        (block.points > min_points &&
         (!is_uniform(first, second) || mean_occupancy(level, block) > max_contrast * (density(block) + 1)))) {
      divide(level, first, max_points, found);
      divide(level, second, max_points, found);
      return;
    }
  }
  found.push_back(block);
}

}  // namespace

std::vector<Block> blocks(const PointGrid& grid, std::uint32_t max_points) {
  const std::uint32_t merged = max_points / 4;  // measured: smaller tiles have too many points around them
  std::vector<Block> found;
  for (std::size_t i = 0; i < grid.levels().size(); ++i) {
    const Level& level = grid.levels()[i];
    if (i != 0 && level.start.back() - level.start.front() <= merged) continue;
    Block all{static_cast<std::uint32_t>(i), 0, 0, level.columns, level.rows, 0, merged};
    all.points = points_of(level, all);
    divide(level, all, max_points, found);
  }
  return found;
}

/// Cuts a tile:
/// 1. lay cells over the block and the halo around it, of a size that suits the density;
/// 2. gather the points of the block, which the tile owns, then the ghosts around it;
/// 3. gather ghosts of other levels, where the halo leaves the box of the block's level;
/// 4. mark as unknown the cells in which points were left out, or hidden points lie;
/// 5. sort the points into the cells, by counting.
void Cutter::cut(const Block& block, Tile& tile) {
  const Level& level = grid_.levels()[block.level];
  tile.clear();
  if (block.points > Tile::max_points) return;
  lay_cells(level, block, tile);
  gather(level, block, tile);
  if (block.level != 0) gather_beyond(level, tile);
  if (!hidden_.none()) forget_hidden(level, tile);
  sort_into_cells(tile);
}

/// Lays cells whose size suits the block: the cells of the level suit the level's points on average only.
void Cutter::lay_cells(const Level& level, const Block& block, Tile& tile) {
  const double width = block.columns * level.cell, height = block.rows * level.cell;
  // If density varies, most points lie where it is above the mean. Points in rows have this effect too, but less.
  const double mean = density(block), seen = mean_occupancy(level, block) - 1;
  const double finer = seen > 1.5 * mean ? std::sqrt(std::min(seen / mean, 4.0)) : 1;
  const double ratio = std::sqrt(points_per_cell / mean) / finer;
  tile.cell = level.cell * std::max(ratio, std::max(block.columns, block.rows) / 1024.0);
  const int beyond = static_cast<int>(std::ceil(margin * finer));
  tile.columns = static_cast<int>(std::ceil(width / tile.cell)) + 2 * beyond;
  tile.rows = static_cast<int>(std::ceil(height / tile.cell)) + 2 * beyond;
  tile.x0 = level.x + block.column * level.cell - beyond * tile.cell;
  tile.y0 = level.y + block.row * level.cell - beyond * tile.cell;
  if (block.level == 0) {
    tile.nothing_left = tile.x0 <= level.x && !hidden_.are_left();
    tile.nothing_below = tile.y0 <= level.y && !hidden_.are_below();
    tile.nothing_right = tile.x1() >= level.x + level.width && !hidden_.are_right();
    tile.nothing_above = tile.y1() >= level.y + level.height && !hidden_.are_above();
  }
  sites_.clear();
  all_ = 0;
  count_.assign(tile.cells() + 1, 0);
  unknown_.assign(tile.cells(), 0);
  any_unknown_ = false;
}

void Cutter::gather(const Level& level, const Block& block, Tile& tile) {
  for_each_row(level, block, [&](std::uint32_t first, std::uint32_t last) {
    for_each_grid(level, block.merged, first, last, [&](std::uint32_t cell) {
      add(level.start[first], level.start[cell]);
      first = cell + 1;
    });
    add(level.start[first], level.start[last]);
  });
  owned_ = all_;

  // Points of cells with more than `dense` points are left out, around the block and around the grids in it: to gather
  // the points would cost more time than to leave the triangles along the edge of a dense cell to the remainder.
  const std::uint32_t dense =
      std::max(std::max(64u, block.merged), 16 * block.points / static_cast<std::uint32_t>(block.columns * block.rows));
  const std::size_t max_all = max_points_around(owned_);
  const auto columns = static_cast<std::uint32_t>(level.columns);
  const auto forget_cells = [&](std::uint32_t first, std::uint32_t last) {
    const std::uint32_t row = first / columns;
    const double x = level.x + (first - row * columns) * level.cell,
                 x_end = level.x + (last - row * columns) * level.cell;
    const double y = level.y + row * level.cell;
    forget(tile, x - level.slack, x_end + level.slack, y - level.slack, y + level.cell + level.slack);
  };
  const auto take = [&](std::uint32_t first, std::uint32_t last) {
    if (all_ + (level.start[last] - level.start[first]) <= max_all)
      add(level.start[first], level.start[last]);
    else
      forget_cells(first, last);
  };
  const auto take_but_dense = [&](std::uint32_t first, std::uint32_t last) {
    if (first == last) return;
    for_each_grid(level, dense, first, last, [&](std::uint32_t cell) {
      take(first, cell);
      forget_cells(cell, cell + 1);
      first = cell + 1;
    });
    take(first, last);
  };
  const auto far_c0 = static_cast<std::uint32_t>(level.column(tile.x0)),
             far_c1 = static_cast<std::uint32_t>(level.column(tile.x1())) + 1;
  for (int r = level.row(tile.y0); r <= level.row(tile.y1()); ++r) {
    const std::uint32_t row = static_cast<std::uint32_t>(r) * columns;
    if (r < block.row || r >= block.row + block.rows) {
      take_but_dense(row + far_c0, row + far_c1);
      continue;
    }
    const std::uint32_t c0 = row + static_cast<std::uint32_t>(block.column),
                        c1 = c0 + static_cast<std::uint32_t>(block.columns);
    take_but_dense(row + far_c0, c0);
    for_each_grid(level, block.merged, c0, c1, [&](std::uint32_t cell) { take_but_dense(cell, cell + 1); });
    take_but_dense(c1, row + far_c1);
  }
}

/// Gathers the points of the tile's box that are outside of the level's box, and so belong to other levels.
void Cutter::gather_beyond(const Level& level, const Tile& tile) {
  const std::uint32_t first_inside = level.start.front(), last_inside = level.start.back();
  const std::size_t max_all = max_points_around(owned_);
  const auto take = [&](std::uint32_t first, std::uint32_t last) {
    if (all_ + (last - first) <= max_all) return add(first, last);
    for (std::uint32_t s = first; s < last; ++s) {
      const Point& p = grid_.points()[s];
      forget(tile, p.x, p.x, p.y, p.y);
    }
  };
  // A range of sites may begin or end among the sites of the level.
  grid_.scan({{tile.x0, tile.y0}, {tile.x1(), tile.y1()}}, [&](std::uint32_t first, std::uint32_t last) {
    if (first < first_inside) take(first, std::min(last, first_inside));
    if (last > last_inside) take(std::max(first, last_inside), last);
  });
}

void Cutter::forget_hidden(const Level& level, const Tile& tile) {
  const double slack = level.slack;
  hidden_.in_box({{tile.x0, tile.y0}, {tile.x1(), tile.y1()}},
                 [&](const Point& p) { forget(tile, p.x - slack, p.x + slack, p.y - slack, p.y + slack); });
}

void Cutter::add(std::uint32_t first, std::uint32_t last) {
  if (first == last) return;
  sites_.push_back({first, last});
  all_ += last - first;
}

void Cutter::forget(const Tile& tile, double x_low, double x_high, double y_low, double y_high) {
  if (x_high < tile.x0 || x_low > tile.x1() || y_high < tile.y0 || y_low > tile.y1()) return;
  for (int r = tile.row(y_low); r <= tile.row(y_high); ++r)
    for (int c = tile.column(x_low); c <= tile.column(x_high); ++c)
      unknown_[static_cast<std::size_t>(r * tile.columns + c)] = 1;
  any_unknown_ = true;
}

/// Sorts the points into cells, and leaves out ghosts beyond the tile's box.
void Cutter::sort_into_cells(Tile& tile) {
  const std::size_t cells = tile.cells();
  const auto points = grid_.points();
  cell_of_.resize(all_);
  const double x0 = tile.x0, y0 = tile.y0, per_cell = 1 / tile.cell;
  const double x1 = tile.x1(), y1 = tile.y1(), last_column = tile.columns - 1, last_row = tile.rows - 1;
  const auto columns = static_cast<std::uint32_t>(tile.columns), beyond = static_cast<std::uint32_t>(cells);
  std::size_t next = 0;
  for (const auto& [first, last] : sites_)
    for (std::uint32_t s = first; s < last; ++s) {
      const Point& p = points[s];
      const auto c = static_cast<std::uint32_t>(std::clamp((p.x - x0) * per_cell, 0.0, last_column));
      const auto r = static_cast<std::uint32_t>(std::clamp((p.y - y0) * per_cell, 0.0, last_row));
      const bool is_here = (p.x >= x0) & (p.x <= x1) & (p.y >= y0) & (p.y <= y1);
      // Points beyond the box are counted in one more cell, the last.
      const std::uint32_t cell = (is_here | (next < owned_)) ? r * columns + c : beyond;
      cell_of_[next++] = cell;
      ++count_[cell];
    }
  if (any_unknown_) {
    tile.unknown.resize(cells + 1);
    for (std::size_t c = 0; c < cells; ++c)
      tile.unknown[c + 1] = static_cast<std::uint16_t>(tile.unknown[c] + unknown_[c]);
  }
  tile.start.resize(cells + 1);
  std::uint32_t sum = 0;
  for (std::size_t c = 0; c <= cells; ++c) {
    tile.start[c] = static_cast<std::uint16_t>(sum);
    sum += count_[c];
    count_[c] = tile.start[c];
  }
  tile.points.resize(sum);
  tile.site.resize(sum);
  tile.owned.resize(sum);
  next = 0;
  for (const auto& [first, last] : sites_)
    for (std::uint32_t s = first; s < last; ++s) {
      const std::uint32_t at = count_[cell_of_[next]]++;
      tile.points[at] = points[s];
      tile.site[at] = s;
      tile.owned[at] = next++ < owned_;
    }
  const std::size_t here = tile.start[cells];
  tile.points.resize(here);
  tile.site.resize(here);
  tile.owned.resize(here);
}

}  // namespace rbpa
