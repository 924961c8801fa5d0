// What: a part of the plane that is triangulated on its own: the points it owns, ghosts all around them, and the cells
//       whose points it lacks.
// Law:  plain data. Results of a tile depend on nothing else, so tiles can be processed in any order and by any thread,
//       or be sent elsewhere.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa {

/// A tile. Points are numbered cell by cell, row by row. The cells' box is x0 … x0 + columns · cell by y0 … y0 + rows ·
/// cell.
struct Tile {
  double x0 = 0, y0 = 0, cell = 0;
  int columns = 0, rows = 0;
  /// Whether there are no points at all beyond the cells on a side.
  bool nothing_left = false, nothing_right = false, nothing_below = false, nothing_above = false;
  std::vector<Point> points;
  std::vector<std::uint32_t> site;   ///< for each point, its site
  std::vector<std::uint8_t> owned;   ///< for each point, 1 if the tile owns the point, 0 if the point is a ghost
  std::vector<std::uint16_t> start;  ///< for each cell its first point; and the end
  /// For each cell, the number of cells before it that lack points in this tile; at the end, the number of all cells
  /// that lack points. Empty if no point is missing.
  std::vector<std::uint16_t> unknown;

  double x1() const { return x0 + columns * cell; }
  double y1() const { return y0 + rows * cell; }
  std::size_t cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  int column(double x) const { return std::clamp(static_cast<int>((x - x0) / cell), 0, columns - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - y0) / cell), 0, rows - 1); }

  void clear() {
    nothing_left = nothing_right = nothing_below = nothing_above = false;
    points.clear();
    site.clear();
    owned.clear();
    start.clear();
    unknown.clear();
  }

  static constexpr std::size_t max_points = 8000;
  static_assert(4 * (2 * max_points + 2) <= 0xffff, "two triangles a point, four numbers a triangle, in 16 bits");
};

}  // namespace rbpa
