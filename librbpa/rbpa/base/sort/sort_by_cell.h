// What: brings points into the order of the cells of a grid.
// Law:  points of one cell keep their order. The result does not depend on the number of threads.
// Cost: linear. From 65,536 points on, each point is first moved to the part of the output that its band of rows fills;
//       then one thread sorts each band within a cache, with a copy of the band's points (24 bytes a point).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point.h"
#include "rbpa/base/sort/distribute.h"

namespace rbpa {

struct NamedPoints {
  std::span<const Point> points;
  const std::uint32_t* names = nullptr;  ///< the name of each point; if null, a point's name is its position
  std::uint32_t name(std::size_t i) const { return names ? names[i] : static_cast<std::uint32_t>(i); }
};

/// Sorts points by cell. Writes the points to `sorted` and their names to `names`. Sets level.start of each cell to
/// `first` plus the position of the cell's first point in `sorted`.
/// Requires: all points lie in the cells `first_cell` … `last_cell` − 1; `sorted` and `names` have a place for each
///           point, and do not overlap the input.
template <typename Level>
void sort_by_cell(const NamedPoints& input, Level& level, std::size_t first_cell, std::size_t last_cell,
                  std::uint32_t first, Point* sorted, std::uint32_t* names) {
  const std::size_t n = input.points.size();
  const std::size_t cells = last_cell - first_cell;
  std::uint32_t* const start = level.start.data() + first_cell;
  std::fill_n(start, cells, 0);
  meshops::FreshVector<std::uint32_t> cell_of(n);
  for (std::size_t i = 0; i < n; ++i) {
    cell_of[i] = level.cell_of(input.points[i]) - static_cast<std::uint32_t>(first_cell);
    ++start[cell_of[i]];
  }
  std::uint32_t end = 0;
  for (std::size_t c = 0; c < cells; ++c) start[c] = end += start[c];
  for (std::size_t i = n; i-- > 0;) {
    const std::uint32_t at = --start[cell_of[i]];
    sorted[at] = input.points[i];
    names[at] = input.name(i);
  }
  for (std::size_t c = 0; c < cells; ++c) start[c] += first;
}

/// Sorts points by cell over all cells of a level. Sets level.start for every cell, and the end as a last entry. Uses
/// `threads` from 65,536 points on.
template <typename Level>
void sort_by_cell(const NamedPoints& input, Level& level, std::uint32_t first, Point* sorted, std::uint32_t* names,
                  Threads& threads) {
  constexpr std::size_t at_a_time = 1u << 16, points_per_band = 1u << 15, max_bands = 1024;
  const std::size_t n = input.points.size(), rows = static_cast<std::size_t>(level.rows),
                    columns = static_cast<std::size_t>(level.columns);
  level.start.resize(rows * columns + 1);
  level.start.back() = first + static_cast<std::uint32_t>(n);
  const std::size_t wanted = std::min(n / points_per_band, max_bands);
  if (wanted < 2) return sort_by_cell(input, level, 0, rows * columns, first, sorted, names);

  int shift = 0;  // a band has 2^shift rows
  while ((rows >> shift) > wanted) ++shift;
  const std::size_t bands = ((rows - 1) >> shift) + 1;
  const std::vector<std::uint32_t> band_start = distribute(
      n, bands, at_a_time, threads,
      [&](std::size_t i) { return static_cast<std::size_t>(level.row(input.points[i].y) >> shift); },
      [&](std::size_t i, std::uint32_t at) {
        sorted[at] = input.points[i];
        names[at] = input.name(i);
      });
  for_each_index(threads, bands, [&](std::size_t band) {
    const std::uint32_t from = band_start[band], to = band_start[band + 1];
    const meshops::FreshVector<Point> parted(sorted + from, sorted + to);
    const meshops::FreshVector<std::uint32_t> parted_names(names + from, names + to);
    sort_by_cell({parted, parted_names.data()}, level, (band << shift) * columns,
                 std::min((band + 1) << shift, rows) * columns, first + from, sorted + from, names + from);
  });
}

}  // namespace rbpa
