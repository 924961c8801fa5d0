// What: a tile's points in single precision, relative to one of them, scaled so that the tile is within −1 … 1.
// Law:  every coordinate is within `rounding` of the true one; on a lattice it is exact.
// Why:  sixteen coordinates fit a vector register, and nothing can overflow. Decisions use bounds that allow for the
//       rounding; docs/explanation/plane.md, section 10, derives the bounds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/plane/tile/tile.h"

namespace rbpa {

struct TileCoordinates {
  static constexpr float unit_roundoff = 0x1p-24f;
  static constexpr float rounding = 0x1.05p-25f;  ///< half a unit in the last place below 1, and earlier rounding
  static constexpr std::size_t padding = 16;      ///< floats that can be read after the last

  double scale = 1;  ///< a power of two
  std::vector<float> x, y;
  std::vector<std::int32_t> start, unknown;  ///< as in the tile; followed by three empty rows
  int columns = 0, rows = 0;
  float x0 = 0, y0 = 0, cell = 0, per_cell = 0;
  /// The box in which the tile has all points, except those of unknown cells; infinite on sides without further points.
  float x_low = 0, x_high = 0, y_low = 0, y_high = 0;
  /// Maximum extent of a box in which differences of points have exact products, and exact sums of two products, in
  /// single precision; 0 if the points are not on a lattice.
  float lattice_extent = 0;

  /// Replaces all members by those of a tile. Requires: a tile with points.
  void assign(const Tile& tile);

  int column(float at) const { return clamp((at - x0) * per_cell, columns); }
  int row(float at) const { return clamp((at - y0) * per_cell, rows); }
  bool is_known(int c0, int c1, int r0, int r1) const;

 private:
  static int clamp(float cells, int count) {
    return static_cast<int>(std::max(0.0f, std::min(cells, static_cast<float>(count - 1))));
  }
};

}  // namespace rbpa
