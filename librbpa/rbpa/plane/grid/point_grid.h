// What: lays out the distinct points in cells that hold a few points each.
// Law:  the cells follow the points, never alpha: a cell with many points is a grid of its own, so clusters of any
//       density are found as fast as uniform points. scan() reaches every point of a box.
// Cost: construction, by all threads, is linear if the density varies within bounds; each √n-fold rise of the density
//       adds a level. Memory: 20 bytes a point and 4 a cell. scan() is linear in the rows that the box meets and the
//       points in its cells.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/sort/sort_by_cell.h"
#include "rbpa/plane/grid/box.h"

namespace rbpa {

class PointGrid {
 public:
  /// Lays out finite points, fewer than 2³⁰. Without `threads`, the calling thread lays out all of them. Calls
  /// `checkpoint`, if any, before each level is refined; `checkpoint` may throw.
  PointGrid(std::span<const Point> input, Threads& threads, const Checkpoint& checkpoint = {})
      : PointGrid(NamedPoints{input}, threads, checkpoint) {}
  explicit PointGrid(std::span<const Point> input);
  /// Lays out points with given names, which ascend.
  PointGrid(const NamedPoints& input, Threads& threads, const Checkpoint& checkpoint = {});

  /// Returns the distinct points in the order of their cells. A position in this list is called a site.
  std::span<const Point> points() const { return points_; }
  /// Returns for each site the name of its point, of equal points the lowest; names are input indices unless given.
  std::span<const std::uint32_t> input_index() const { return index_; }
  const std::vector<Duplicate>& duplicates() const { return duplicates_; }

  /// Returns an upper bound of the distance of any two points.
  double diameter_bound() const { return levels_.empty() ? 0 : 2 * (levels_[0].width + levels_[0].height); }

  /// Calls visit(first, last) for ranges of sites, first to last − 1, that together hold every point of the box and
  /// some near the box.
  template <typename Visit>
  void scan(const Box& box, Visit visit) const {
    if (!levels_.empty()) scan_level(levels_[0], box, visit);
  }

  struct Child {
    std::uint32_t cell, level;
  };
  /// A grid of square cells over the box from (x, y) to (x + width, y + height); the first is over all points. `cell`
  /// is the side of a cell, `per_unit` is 1 / cell.
  struct Level {
    double x, y, width, height, cell, per_unit;
    double slack;  ///< upper bound of the rounding error in the coordinates of a cell's sides
    int columns, rows;
    std::vector<std::uint32_t> start;  // for each cell, row by row, its first site; then the end
    std::vector<Child> children;       // the cells that are grids of their own, ascending
    std::vector<std::uint32_t> child;  // for each row, the first of its children; and the end. Empty without children

    /// Returns the first child whose cell is `from` or a later cell of the same row; if there is none, the end of the
    /// row's children.
    auto child_at(std::uint32_t from) const {
      if (children.empty()) return children.end();
      const std::size_t row_number = from / static_cast<std::uint32_t>(columns);
      const auto first = children.begin() + child[row_number], last = children.begin() + child[row_number + 1];
      return std::lower_bound(first, last, from, [](const Child& c, std::uint32_t at) { return c.cell < at; });
    }

    static int clamp(double cells, int count) {
      if (!(cells > 0)) return 0;
      return cells >= double(count) ? count - 1 : static_cast<int>(cells);
    }
    // column() and row() are monotone in the coordinate, rounding included: a point between two bounds is in a cell
    // between the cells of the bounds.
    int column(double at) const { return clamp((at - x) * per_unit, columns); }
    int row(double at) const { return clamp((at - y) * per_unit, rows); }
    std::uint32_t cell_of(const Point& p) const {
      return static_cast<std::uint32_t>(row(p.y)) * static_cast<std::uint32_t>(columns) +
             static_cast<std::uint32_t>(column(p.x));
    }
  };
  const std::vector<Level>& levels() const { return levels_; }

 private:
  static constexpr double points_per_cell = 2;
  static constexpr std::uint32_t max_in_cell = 24;  ///< a cell with more points is a grid of its own
  /// Number of preceding points with which repeats_nearby() compares each point.
  static constexpr std::uint32_t nearby = 3;

  /// Duplicates found in some cells: the sites to be left out, and the entries of duplicates().
  struct Repeated {
    std::vector<std::uint32_t> sites;
    std::vector<Duplicate> duplicates;
  };

  static Level make_level(std::span<const Point> points, Threads& threads);
  void refine(Threads& threads, const Checkpoint& checkpoint);
  std::optional<Level> level_of(std::uint32_t first, std::uint32_t last, Threads& threads);
  static void index_children(Level& level);
  void remove_duplicates(Threads& threads);
  void find_duplicates(const Level& level, std::size_t first_cell, std::size_t last_cell, Repeated& found) const;
  void find_duplicates(std::uint32_t first, std::uint32_t last, Repeated& found) const;
  bool repeats_nearby(std::uint32_t first, std::uint32_t last) const;
  void leave_out(std::vector<std::uint32_t> repeated);

  template <typename Visit>
  void scan_level(const Level& level, const Box& box, Visit& visit) const;

  meshops::FreshVector<Point> points_;
  meshops::FreshVector<std::uint32_t> index_;
  std::vector<Duplicate> duplicates_;
  std::vector<Level> levels_;
};

template <typename Visit>
void PointGrid::scan_level(const Level& level, const Box& box, Visit& visit) const {
  const int first_column = level.column(box.low.x), last_column = level.column(box.high.x);
  for (int r = level.row(box.low.y), last_row = level.row(box.high.y); r <= last_row; ++r) {
    const auto row = static_cast<std::uint32_t>(r) * static_cast<std::uint32_t>(level.columns);
    const std::uint32_t c0 = row + static_cast<std::uint32_t>(first_column),
                        c1 = row + static_cast<std::uint32_t>(last_column) + 1;
    std::uint32_t first = level.start[c0];
    const std::uint32_t last = level.start[c1];
    if (last - first > max_in_cell && !level.children.empty()) {
      for (auto child = level.child_at(c0); child != level.children.end() && child->cell < c1; ++child) {
        if (first < level.start[child->cell]) visit(first, level.start[child->cell]);
        scan_level(levels_[child->level], box, visit);
        first = level.start[child->cell + 1];
      }
    }
    if (first < last) visit(first, last);
  }
}

}  // namespace rbpa
