#include "rbpa/plane/grid/point_grid.h"

#include <bit>

#include "meshops/core/large_pages.h"
#include "rbpa/base/exact/two.h"

namespace rbpa {
namespace {

constexpr std::size_t cells_at_a_time = 1u << 15;  // number of cells for one thread

}  // namespace

PointGrid::PointGrid(const NamedPoints& input, Threads& threads, const Checkpoint& checkpoint) {
  const std::size_t count = input.points.size();
  if (count == 0) return;
  points_.resize(count);
  index_.resize(count);
  levels_.push_back(make_level(input.points, threads));
  sort_by_cell(input, levels_[0], 0, points_.data(), index_.data(), threads);
  refine(threads, checkpoint);
  remove_duplicates(threads);
}

PointGrid::PointGrid(std::span<const Point> input) {
  Threads one;
  *this = PointGrid(input, one);
}

/// Returns a grid over the box of the points, whose cells are not filled yet.
auto PointGrid::make_level(std::span<const Point> points, Threads& threads) -> Level {
  const auto [low, high] = box_of(points, threads);
  Level level;
  level.x = low.x;
  level.y = low.y;
  level.width = high.x - low.x;
  level.height = high.y - low.y;
  const auto count = static_cast<double>(points.size());
  // Cells are square; a long thin box gets at most a few cells per point, too.
  level.cell = std::max(std::sqrt(level.width) * std::sqrt(level.height) * std::sqrt(points_per_cell / count),
                        std::max(level.width, level.height) * points_per_cell / count);
  if (!(level.cell > 0)) level.cell = 1;  // all points are equal
  level.per_unit = 1 / level.cell;
  level.columns = static_cast<int>(level.width * level.per_unit) + 1;
  level.rows = static_cast<int>(level.height * level.per_unit) + 1;
  const auto largest = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
  level.slack = 16 * 0x1p-53 * (largest(low.x, high.x) + largest(low.y, high.y) + level.width + level.height);
  return level;
}

/// Makes a grid of every cell that has more than max_in_cell points, not all of them equal. Repeats this with the cells
/// of the new grids, until there are no new grids.
void PointGrid::refine(Threads& threads, const Checkpoint& checkpoint) {
  struct DenseCell {
    std::uint32_t level, cell, first, last;
  };
  for (std::size_t from = 0, to = 1; from < to; from = to, to = levels_.size()) {
    if (checkpoint) checkpoint();
    std::vector<DenseCell> dense;
    for (std::size_t i = from; i < to; ++i) {
      const std::vector<std::uint32_t>& start = levels_[i].start;
      for (std::uint32_t cell = 0; cell + 1 < start.size(); ++cell)
        if (start[cell + 1] - start[cell] > max_in_cell)
          dense.push_back({static_cast<std::uint32_t>(i), cell, start[cell], start[cell + 1]});
    }
    std::vector<std::optional<Level>> finer;
    meshops::reserve_in_large_pages(finer, dense.size());
    meshops::reserve_in_large_pages(levels_, levels_.size() + dense.size());
    finer.resize(dense.size());
    for_each_index(threads, dense.size(),
                   [&](std::size_t i) { finer[i] = level_of(dense[i].first, dense[i].last, threads); });
    for (std::size_t i = 0; i < dense.size(); ++i) {
      if (!finer[i]) continue;
      levels_[dense[i].level].children.push_back({dense[i].cell, static_cast<std::uint32_t>(levels_.size())});
      levels_.push_back(std::move(*finer[i]));
    }
    for (std::size_t i = from; i < to; ++i) index_children(levels_[i]);
  }
}

/// Sorts the sites `first` … `last` − 1 into a grid of their own, and returns this grid; nothing if all their points
/// are equal.
auto PointGrid::level_of(std::uint32_t first, std::uint32_t last, Threads& threads) -> std::optional<Level> {
  const meshops::FreshVector<Point> points(points_.begin() + first, points_.begin() + last);
  const meshops::FreshVector<std::uint32_t> index(index_.begin() + first, index_.begin() + last);
  if (std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == points[0]; })) return std::nullopt;
  Level level = make_level(points, threads);
  sort_by_cell({points, index.data()}, level, first, points_.data() + first, index_.data() + first, threads);
  return level;
}

void PointGrid::index_children(Level& level) {
  if (level.children.empty()) return;
  level.child.resize(static_cast<std::size_t>(level.rows) + 1);
  std::size_t next = 0;
  for (int row = 0; row <= level.rows; ++row) {
    const auto first = static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(level.columns);
    while (next < level.children.size() && level.children[next].cell < first) ++next;
    level.child[static_cast<std::size_t>(row)] = static_cast<std::uint32_t>(next);
  }
}

/// Finds every point of a cell that equals an earlier point of the cell. Points of a cell are in input order; more than
/// max_in_cell points are all equal.
void PointGrid::find_duplicates(std::uint32_t first, std::uint32_t last, Repeated& found) const {
  for (std::uint32_t i = first + 1; i < last; ++i) {
    const std::uint32_t end = last - first > max_in_cell ? first + 1 : i;
    const auto found_at = std::find(points_.begin() + first, points_.begin() + end, points_[i]);
    const auto original = static_cast<std::size_t>(found_at - points_.begin());
    if (original == end) continue;
    found.sites.push_back(i);
    found.duplicates.push_back({index_[i], index_[original]});
  }
}

/// Returns whether any of the points `first` … `last` − 1 equals one of the `nearby` points before it. A branch for
/// each point would be mispredicted on a lattice, where half of the points have the x of the point before.
bool PointGrid::repeats_nearby(std::uint32_t first, std::uint32_t last) const {
  decltype(Two<double>() == Two<double>()) repeats = {};
  for (std::uint32_t apart = 1; apart <= nearby; ++apart)
    for (std::uint32_t i = first + apart; i < last; ++i) {
      const auto equal = std::bit_cast<Two<double>>(points_[i]) == std::bit_cast<Two<double>>(points_[i - apart]);
      repeats |= equal & swapped(equal);
    }
  return repeats[0] != 0;
}

/// Finds the duplicates in some cells of a level, except in cells that are grids of their own.
void PointGrid::find_duplicates(const Level& level, std::size_t first_cell, std::size_t last_cell,
                                Repeated& found) const {
  constexpr std::size_t at_once = 64;
  auto child = std::lower_bound(level.children.begin(), level.children.end(), first_cell,
                                [](const Child& c, std::size_t cell) { return c.cell < cell; });
  for (std::size_t from = first_cell; from < last_cell; from += at_once) {
    const std::size_t to = std::min(from + at_once, last_cell);
    const std::uint32_t unseen = repeats_nearby(level.start[from], level.start[to]) ? 1 : nearby + 1;
    for (std::size_t cell = from; cell < to; ++cell) {
      if (level.start[cell + 1] - level.start[cell] <= unseen) continue;
      while (child != level.children.end() && child->cell < cell) ++child;
      if (child == level.children.end() || child->cell != cell)
        find_duplicates(level.start[cell], level.start[cell + 1], found);
    }
  }
}

/// Removes all equal points but the first. Equal points share a cell at every level.
void PointGrid::remove_duplicates(Threads& threads) {
  const std::size_t cells = levels_[0].start.size() - 1, parts = (cells + cells_at_a_time - 1) / cells_at_a_time;
  std::vector<Repeated> found(parts + levels_.size() - 1);
  for_each_index(threads, found.size(), [&](std::size_t i) {
    if (i < parts)
      find_duplicates(levels_[0], i * cells_at_a_time, std::min((i + 1) * cells_at_a_time, cells), found[i]);
    else
      find_duplicates(levels_[i - parts + 1], 0, levels_[i - parts + 1].start.size() - 1, found[i]);
  });
  std::vector<std::uint32_t> repeated;
  for (const Repeated& some : found) {
    repeated.insert(repeated.end(), some.sites.begin(), some.sites.end());
    duplicates_.insert(duplicates_.end(), some.duplicates.begin(), some.duplicates.end());
  }
  if (!repeated.empty()) leave_out(std::move(repeated));
}

void PointGrid::leave_out(std::vector<std::uint32_t> repeated) {
  std::sort(repeated.begin(), repeated.end());
  std::sort(duplicates_.begin(), duplicates_.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.index < b.index; });
  const auto before = [&](std::uint32_t site) {
    return static_cast<std::uint32_t>(std::lower_bound(repeated.begin(), repeated.end(), site) - repeated.begin());
  };
  for (Level& level : levels_)
    for (std::uint32_t& start : level.start) start -= before(start);
  auto next = repeated.begin();
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < index_.size(); ++i) {
    if (next != repeated.end() && *next == i) {
      ++next;
      continue;
    }
    points_[kept] = points_[i];
    index_[kept++] = index_[i];
  }
  points_.resize(kept);
  index_.resize(kept);
}

}  // namespace rbpa
