#include "stream/plan_tiles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

using Kind = TileTree::Part::Kind;

std::int64_t Cell::*along(bool x) { return x ? &Cell::column : &Cell::row; }

class Planner {
 public:
  Planner(double side, const TileLimits& limits) : side_(side), limits_(limits) {}

  TilePlan plan(std::vector<Cell> cells) {
    if (!cells.empty()) divide(0, std::move(cells), {});
    return {std::move(tree_), points_};
  }

 private:
  double begin(std::int64_t number) const { return static_cast<double>(number) * side_; }

  /// Returns the share of a cell, along one axis, within reach of a box that extends from `low` to `high` on the axis.
  double share(std::int64_t number, double low, double high) const {
    const double first = std::max(begin(number), below_or_same(low)),
                 last = std::min(begin(number + 1), above_or_same(high));
    const double part = (last - first) / side_;
    return std::isnan(part) ? 1 : std::clamp(part, 0.0, 1.0);
  }
  double below_or_same(double at) const { return std::isinf(at) ? at : at - limits_.reach; }
  double above_or_same(double at) const { return std::isinf(at) ? at : at + limits_.reach; }

  double near(const Cell& cell, const Region& box) const {
    return static_cast<double>(cell.count) * share(cell.column, box.x0, box.x1) * share(cell.row, box.y0, box.y1);
  }

  /// Returns the bounding box of the cells.
  Region extent_of(std::span<const Cell> cells) const {
    Cell least = cells.front(), greatest = cells.front();
    for (const Cell& cell : cells) {
      least = {std::min(least.column, cell.column), std::min(least.row, cell.row), 0};
      greatest = {std::max(greatest.column, cell.column), std::max(greatest.row, cell.row), 0};
    }
    return {begin(least.column), begin(least.row), begin(greatest.column + 1), begin(greatest.row + 1)};
  }

  /// Throws TooDense if every part of `extent` would have too many points around it. Cutting does not help then.
  void stop_if_dense(const Region& extent, std::span<const Cell> owned, std::span<const Cell> around) const {
    const double wide = extent.x1 - extent.x0, high = extent.y1 - extent.y0;
    const double left = limits_.reach - std::max(wide, high);
    if (!(left >= 0)) return;
    std::uint64_t points = 0;
    const auto count = [&](const Cell& cell) {
      if (begin(cell.column) >= extent.x0 - left && begin(cell.column + 1) <= extent.x1 + left &&
          begin(cell.row) >= extent.y0 - left && begin(cell.row + 1) <= extent.y1 + left)
        points += cell.count;
    };
    std::for_each(owned.begin(), owned.end(), count);
    std::for_each(around.begin(), around.end(), count);
    if (points > limits_.points) throw TooDense{{extent.x0, extent.y0}, points};
  }

  /// Returns the line between columns (between rows if `x` is false) that best halves the `count` points, or nothing if
  /// all points are in one column or row. Sorts `cells`.
  std::optional<double> middle(std::vector<Cell>& cells, bool x, std::uint64_t count) const {
    const auto number = along(x);
    std::sort(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) { return a.*number < b.*number; });
    if (cells.front().*number == cells.back().*number) return std::nullopt;
    std::uint64_t before = 0;
    std::int64_t best = cells.back().*number;
    double least = INFINITY;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0 && cells[i].*number != cells[i - 1].*number) {
        const double off = std::abs(static_cast<double>(before) - static_cast<double>(count) / 2);
        if (off < least) {
          least = off;
          best = cells[i].*number;
        }
      }
      before += cells[i].count;
    }
    return begin(best);
  }

  void divide(std::uint32_t tile, std::vector<Cell> owned, std::vector<Cell> around) {
    stop_if_interrupted();
    const Region box = tree_.box(tile);
    std::erase_if(around, [&](const Cell& cell) { return near(cell, box) == 0; });
    std::uint64_t count = 0;
    for (const Cell& cell : owned) count += cell.count;
    double all = static_cast<double>(count);
    for (const Cell& cell : around) all += near(cell, box);
    const bool fits = count <= limits_.owned && all <= 0.9 * static_cast<double>(limits_.points);
    if (fits) return keep(all);
    const Region extent = extent_of(owned);
    if (all > static_cast<double>(limits_.points)) stop_if_dense(extent, owned, around);
    bool x = extent.x1 - extent.x0 >= extent.y1 - extent.y0;
    std::optional<double> line = middle(owned, x, count);
    if (!line) line = middle(owned, x = !x, count);
    if (!line || !std::isfinite(*line)) return keep(all);  // cut the tile later, by its points

    const std::uint32_t other = tree_.cut(tile, x ? Kind::cut_x : Kind::cut_y, *line);
    const auto number = along(x);
    const auto middle_cell =
        std::partition_point(owned.begin(), owned.end(), [&](const Cell& cell) { return begin(cell.*number) < *line; });
    std::vector<Cell> first(owned.begin(), middle_cell), second(middle_cell, owned.end());
    owned = {};
    std::vector<Cell> around_first = around, around_second = std::move(around);
    around_first.insert(around_first.end(), second.begin(), second.end());
    around_second.insert(around_second.end(), first.begin(), first.end());
    // Finish the first half before the second, so that few cells are in memory at the same time.
    divide(tile, std::move(first), std::move(around_first));
    divide(other, std::move(second), std::move(around_second));
  }

  void keep(double points) { points_ += points; }

  double side_;
  TileLimits limits_;
  TileTree tree_ = {};
  double points_ = 0;
};

}  // namespace

void refuse_dense(const TooDense& dense, const StreamRequest& request, const Budget& budget) {
  const auto text = [](double value) { return text_of(value); };
  throw Failure("--memory " + in_megabytes(request.memory) + ": found " + counted(dense.points, "point") +
                " within 2 alpha = " + text(2 * request.alpha) + " of each other near (" + text(dense.where.x) + ", " +
                text(dense.where.y) + "), expected at most " + std::to_string(budget.tile_points) + " (--memory " +
                in_megabytes(memory_for(dense.points + dense.points / 4, request.threads)) +
                " or a smaller alpha suffices)");
}

TilePlan plan_tiles(const CellCounts& counts, const TileLimits& limits) {
  return Planner(counts.side(), limits).plan(counts.cells());
}

}  // namespace rbpa::app
