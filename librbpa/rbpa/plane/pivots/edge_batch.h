// What: sixteen edges of a front, and for each the state of its pivot.
// Why:  arrays let a register hold one field of many edges.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rbpa {

struct EdgeBatch {
  using Index = std::uint16_t;
  static constexpr Index none = 0xffff;
  static constexpr std::size_t size = 16;
  static constexpr std::size_t rows_at_once = 3,
                               row_length = 16;  ///< maxima of rows of cells, and of points of a row, for `fits`

  // a, b and expected have one entry more than `size`: a loop may write an entry before it tests whether it counts.
  alignas(64) std::int32_t a[size + 1], b[size + 1];  ///< ends of each edge
  alignas(64) float expected[size + 1];  ///< radius to try first: the circumradius of the triangle behind the edge

  alignas(64) float ax[size], ay[size], bx[size], by[size];
  alignas(64) std::int32_t c0[size], c1[size], r0[size], r1[size];  ///< cells to search: their columns and rows
  alignas(64) std::int32_t is_inside[size];  ///< whether the tile has all points there, except in unknown cells
  alignas(64) float extent[size];            ///< of the cells
  /// Whether the cells to search are at most three rows of at most sixteen points; the first point and the number of
  /// points of each row, and a bit for each point that is an end of the edge.
  alignas(64) std::int32_t fits[size];
  alignas(64) std::int32_t first[rows_at_once][size], count[rows_at_once][size], ends[rows_at_once][size];

  /// In half-chords left of the chord's middle: how far centers of circles are of interest, and an upper bound for the
  /// center of the apex's circle, infinite without an apex. `is_verified`: whether no other point can win.
  alignas(64) float k[size], high[size];
  alignas(64) std::int32_t is_verified[size];

  /// The apex of each edge, or `none`, and the radius of the circle through edge and apex.
  Index apex[size];
  alignas(64) float found_radius[size];
};

}  // namespace rbpa
