#include "rbpa/search/point_grid.h"

#include <algorithm>
#include <numeric>

#include "meshops/core/large_pages.h"

namespace rbpa {

template <typename Real>
PointGrid<Real>::PointGrid(std::span<const Point> input) {
  if (input.empty()) return;
  points_.reserve(input.size() + padding);
  index_.reserve(input.size());
  meshops::prefer_large_pages(points_.data(), points_.capacity() * sizeof(Point));
  meshops::prefer_large_pages(index_.data(), index_.capacity() * sizeof(index_[0]));
  points_.resize(input.size() + padding);
  index_.resize(input.size());
  levels_.push_back(make_level(input));
  sort_into_cells(levels_[0], input, {}, 0);
  for (std::size_t i = 0; i < levels_.size(); ++i) refine(i);
  remove_repetitions();
}

/// A grid over the box of some points, its cells still empty.
template <typename Real>
auto PointGrid<Real>::make_level(std::span<const Point> points) -> Level {
  Point low = points[0], high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  Level level;
  level.x = low.x;
  level.y = low.y;
  level.width = Real(high.x) - Real(low.x);
  level.height = Real(high.y) - Real(low.y);
  const Real count = Real(points.size());
  // Square cells; a long thin box gets no more than a few cells per point either.
  level.cell = std::max(std::sqrt(level.width) * std::sqrt(level.height) * std::sqrt(points_per_cell / count),
                        std::max(level.width, level.height) * points_per_cell / count);
  if (!(level.cell > 0)) level.cell = 1;  // all points are one
  level.per_unit = 1 / level.cell;
  level.columns = static_cast<int>(level.width * level.per_unit) + 1;
  level.rows = static_cast<int>(level.height * level.per_unit) + 1;
  const auto largest = [](double a, double b) { return Real(std::max(std::abs(a), std::abs(b))); };
  level.slack =
      16 * Predicates<Real>::unit * (largest(low.x, high.x) + largest(low.y, high.y) + level.width + level.height);
  return level;
}

/// Puts points into sites from `first` on, sorted by cell, keeping the order of those in one cell. `index` gives their
/// input indices; empty, they are their positions.
template <typename Real>
void PointGrid<Real>::sort_into_cells(Level& level, std::span<const Point> points, std::span<const std::uint32_t> index,
                                      std::uint32_t first) {
  const auto cells = static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows);
  std::vector<std::uint32_t> cell_of(points.size());
  level.start.assign(cells + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    cell_of[i] = static_cast<std::uint32_t>(level.row(Real(points[i].y))) * static_cast<std::uint32_t>(level.columns) +
                 static_cast<std::uint32_t>(level.column(Real(points[i].x)));
    ++level.start[cell_of[i]];
  }
  std::uint32_t end = first;
  for (std::uint32_t& start : level.start) start = end += start;
  for (std::size_t i = points.size(); i-- > 0;) {
    const std::uint32_t site = --level.start[cell_of[i]];
    points_[site] = points[i];
    index_[site] = index.empty() ? static_cast<std::uint32_t>(i) : index[i];
  }
}

/// Finds every point of [first, last) that equals one before it. The range is in input order.
template <typename Real>
void PointGrid<Real>::find_repetitions(std::uint32_t first, std::uint32_t last, std::vector<std::uint32_t>& repeated) {
  const auto note = [&](std::uint32_t repetition, std::uint32_t original) {
    repeated.push_back(repetition);
    repetitions_.push_back({index_[repetition], index_[original]});
  };
  if (last - first <= 8) {
    for (std::uint32_t i = first + 1; i < last; ++i)
      for (std::uint32_t j = first; j < i; ++j)
        if (points_[i] == points_[j]) {
          note(i, j);  // j is the first of its equals, as the search goes upward
          break;
        }
    return;
  }
  std::vector<std::uint32_t> order(last - first);
  std::iota(order.begin(), order.end(), first);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points_[i] == points_[j] ? i < j : points_[i] < points_[j];
  });
  std::uint32_t original = order[0];
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (points_[order[k]] == points_[original])
      note(order[k], original);
    else
      original = order[k];
  }
}

/// Leaves one of all equal points, in every cell where it was. Equal points share a cell at every level.
template <typename Real>
void PointGrid<Real>::remove_repetitions() {
  std::vector<std::uint32_t> repeated;  // sites
  for (const Level& level : levels_) {
    auto child = level.children.begin();
    for (std::uint32_t cell = 0; cell + 1 < level.start.size(); ++cell) {
      if (child != level.children.end() && child->cell == cell)
        ++child;  // its own cells are looked into
      else if (level.start[cell + 1] - level.start[cell] > 1)
        find_repetitions(level.start[cell], level.start[cell + 1], repeated);
    }
  }
  if (repeated.empty()) return;
  std::sort(repeated.begin(), repeated.end());
  std::sort(repetitions_.begin(), repetitions_.end(),
            [](const Repetition& a, const Repetition& b) { return a.index < b.index; });

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
  points_.resize(kept + padding);
  index_.resize(kept);
}

/// Makes a grid of every cell with too many points, unless all are one: each grid parts its points.
template <typename Real>
void PointGrid<Real>::refine(std::size_t level) {
  for (std::uint32_t cell = 0; cell + 1 < levels_[level].start.size(); ++cell) {
    const std::uint32_t first = levels_[level].start[cell], last = levels_[level].start[cell + 1];
    if (last - first <= most_in_cell) continue;
    const std::vector<Point> points(points_.begin() + first, points_.begin() + last);
    const std::vector<std::uint32_t> index(index_.begin() + first, index_.begin() + last);
    if (std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == points[0]; })) continue;
    Level finer = make_level(points);
    sort_into_cells(finer, points, index, first);
    levels_[level].children.push_back({cell, static_cast<std::uint32_t>(levels_.size())});
    levels_.push_back(std::move(finer));
  }
  Level& refined = levels_[level];
  if (refined.children.empty()) return;
  refined.child.resize(static_cast<std::size_t>(refined.rows) + 1);
  std::size_t next = 0;
  for (int row = 0; row <= refined.rows; ++row) {
    const auto first = static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(refined.columns);
    while (next < refined.children.size() && refined.children[next].cell < first) ++next;
    refined.child[static_cast<std::size_t>(row)] = static_cast<std::uint32_t>(next);
  }
}

template class PointGrid<double>;
template class PointGrid<long double>;

}  // namespace rbpa
