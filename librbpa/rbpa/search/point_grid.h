// What: the distinct points, laid out in cells that hold a few each, for range searches.
// Law:  the cells follow the points, never alpha: a cell with many points is a grid of its own, so that clusters of any
//       density are found as fast as uniform points. scan() reaches every point of a region.
// Cost: construction, by all threads, linear for bounded variation of density, one more level per √n-fold rise of it; memory 20 bytes a
//       point and 4 a cell; scan linear in the rows the region meets and the points in its cells.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/core/point.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/search/region.h"

namespace rbpa {

template <typename Real>
class PointGrid {
 public:
  /// A pair of input indices: a repetition, and the lowest index of the same point.
  struct Repetition {
    std::uint32_t index, stands_for;
  };

  /// Requires finite points, fewer than 2³⁰. Without `threads`, the calling one does it. Calls `ask`, if any, after each
  /// level, which may throw.
  PointGrid(std::span<const Point> input, Threads& threads, const std::function<void()>& ask = {});
  explicit PointGrid(std::span<const Point> input);

  /// The distinct points in the order of their cells. A position in it is called a site.
  /// Behind the last, `padding` more can be read.
  std::span<const Point> points() const { return {points_.data(), index_.size()}; }
  static constexpr std::size_t padding = 7;
  /// The (lowest) input index of each site.
  std::span<const std::uint32_t> input_index() const { return index_; }
  const std::vector<Repetition>& repetitions() const { return repetitions_; }

  /// The side of a cell at the coarsest level: the scale at which a search does well to begin.
  Real cell_size() const { return levels_.empty() ? 0 : levels_[0].cell; }
  /// The side of the cell around a point of the input, at the finest level there.
  Real cell_size_at(const Point& p) const;
  /// No two points are farther apart than this.
  Real diameter_bound() const { return levels_.empty() ? 0 : 2 * (levels_[0].width + levels_[0].height); }

  /// Calls visit(first, last) for ranges of sites that together hold every point of the region, and others near it.
  template <typename Visit>
  void scan(const Region<Real>& region, Visit visit) const {
    if (!levels_.empty()) scan_level(levels_[0], region, visit);
  }

  struct Child {
    std::uint32_t cell, level;
  };
  /// A grid of cells; the first is over all points.
  struct Level {
    Real x, y, width, height, cell, per_unit, slack;
    int columns, rows;
    std::vector<std::uint32_t> start;  // of each cell, row by row, the first site; and the end
    std::vector<Child> children;       // the cells that are grids of their own, ascending
    std::vector<std::uint32_t> child;  // of each row, the first of its children; and the end. Empty without children

    /// The first child of a row that is not before a cell of it.
    auto child_at(int row_number, std::uint32_t from) const {
      if (children.empty()) return children.end();
      const auto first = children.begin() + child[static_cast<std::size_t>(row_number)];
      const auto last = children.begin() + child[static_cast<std::size_t>(row_number) + 1];
      return std::lower_bound(first, last, from, [](const Child& c, std::uint32_t at) { return c.cell < at; });
    }

    int clamp(Real cells, int count) const {
      if (!(cells > 0)) return 0;
      return cells >= Real(count) ? count - 1 : static_cast<int>(cells);
    }
    // Monotone in the coordinate, rounding included: a point between two bounds is in a cell between theirs.
    int column(Real at) const { return clamp((at - x) * per_unit, columns); }
    int row(Real at) const { return clamp((at - y) * per_unit, rows); }
    int row_of(const Point& p) const { return row(Real(p.y)); }
    std::uint32_t cell_of(const Point& p) const {
      return static_cast<std::uint32_t>(row_of(p)) * static_cast<std::uint32_t>(columns) +
             static_cast<std::uint32_t>(column(Real(p.x)));
    }
  };
  const std::vector<Level>& levels() const { return levels_; }

 private:
  static constexpr Real points_per_cell = 2;
  static constexpr std::uint32_t most_in_cell = 24;  ///< a cell with more is a grid of its own
  static constexpr int small_box = 8;                ///< rows and columns

  /// Repetitions found together: the sites to be left out, and what they are.
  struct Repeated {
    std::vector<std::uint32_t> sites;
    std::vector<Repetition> repetitions;
  };

  static Level make_level(std::span<const Point> points, Threads& threads);
  void refine(Threads& threads, const std::function<void()>& ask);
  std::optional<Level> level_of(std::uint32_t first, std::uint32_t last, Threads& threads);
  static void index_children(Level& level);
  void remove_repetitions(Threads& threads);
  void find_repetitions(const Level& level, std::size_t first_cell, std::size_t last_cell, Repeated& found) const;
  void find_repetitions(std::uint32_t first, std::uint32_t last, Repeated& found) const;
  void leave_out(std::vector<std::uint32_t> repeated);

  template <typename Visit>
  void scan_level(const Level& level, const Region<Real>& region, Visit& visit) const;

  meshops::FreshVector<Point> points_;  // with padding
  meshops::FreshVector<std::uint32_t> index_;
  std::vector<Repetition> repetitions_;
  std::vector<Level> levels_;
};

template <typename Real>
Real PointGrid<Real>::cell_size_at(const Point& p) const {
  for (const Level* level = &levels_[0];;) {
    const std::uint32_t cell = level->cell_of(p);
    if (level->start[cell + 1] - level->start[cell] <= most_in_cell) return level->cell;
    const auto child = level->child_at(level->row_of(p), cell);
    if (child == level->children.end() || child->cell != cell) return level->cell;
    level = &levels_[child->level];
  }
}

template <typename Real>
template <typename Visit>
void PointGrid<Real>::scan_level(const Level& level, const Region<Real>& region, Visit& visit) const {
  const int first_row = level.row(region.y_range().low), last_row = level.row(region.y_range().high);
  const int first_column = level.column(region.x_range().low), last_column = level.column(region.x_range().high);
  // In a small box the cells beyond the region's outline hold fewer points than it costs to find the outline.
  const bool small = last_row - first_row < small_box && last_column - first_column < small_box;
  auto c0 = static_cast<std::uint32_t>(first_row) * static_cast<std::uint32_t>(level.columns) +
            static_cast<std::uint32_t>(first_column);
  auto c1 = c0 + static_cast<std::uint32_t>(last_column - first_column) + 1;
  for (int r = first_row; r <= last_row; ++r) {
    if (!small) {
      const Real low = level.y + Real(r) * level.cell - level.slack, high = low + level.cell + 2 * level.slack;
      const auto x = region.row(low, high);
      if (x.empty()) continue;
      const auto row_start = static_cast<std::uint32_t>(r) * static_cast<std::uint32_t>(level.columns);
      c0 = row_start + static_cast<std::uint32_t>(level.column(x.low));
      c1 = row_start + static_cast<std::uint32_t>(level.column(x.high)) + 1;
    }
    std::uint32_t first = level.start[c0];
    const std::uint32_t last = level.start[c1];
    if (last - first > most_in_cell && !level.children.empty()) {
      for (auto child = level.child_at(r, c0); child != level.children.end() && child->cell < c1; ++child) {
        if (first < level.start[child->cell]) visit(first, level.start[child->cell]);
        scan_level(levels_[child->level], region, visit);
        first = level.start[child->cell + 1];
      }
    }
    if (first < last) visit(first, last);
    c0 += static_cast<std::uint32_t>(level.columns);
    c1 += static_cast<std::uint32_t>(level.columns);
  }
}

extern template class PointGrid<double>;
extern template class PointGrid<long double>;

}  // namespace rbpa
