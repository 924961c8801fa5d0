#include "rbpa/search/point_grid.h"

#include <algorithm>
#include <numeric>

namespace rbpa {

template <typename Real>
PointGrid<Real>::PointGrid(std::span<const Point> input) {
  if (input.empty()) return;
  points_.resize(input.size() + padding);
  index_.resize(input.size());
  Level root = make_level(input);
  sort_into_cells(root, input, {}, 0);
  remove_repetitions(root);
  levels_.push_back(std::move(root));
  for (std::size_t i = 0; i < levels_.size(); ++i) refine(i);
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

/// Marks every point of [first, last) that equals one before it. The range is in input order.
template <typename Real>
bool PointGrid<Real>::keep_first_of_equals(std::uint32_t first, std::uint32_t last,
                                           std::vector<std::uint8_t>& repeated) {
  bool any = false;
  const auto mark = [&](std::uint32_t repetition, std::uint32_t original) {
    if (!any) repeated.assign(last - first, 0);
    any = true;
    repeated[repetition - first] = 1;
    repetitions_.push_back({index_[repetition], index_[original]});
  };
  if (last - first <= 8) {
    for (std::uint32_t i = first + 1; i < last; ++i)
      for (std::uint32_t j = first; j < i; ++j)
        if (points_[i] == points_[j]) {
          mark(i, j);  // j is the first of its equals, as the search goes upward
          break;
        }
    return any;
  }
  std::vector<std::uint32_t> order(last - first);
  std::iota(order.begin(), order.end(), first);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points_[i] == points_[j] ? i < j : points_[i] < points_[j];
  });
  std::uint32_t original = order[0];
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (points_[order[k]] == points_[original])
      mark(order[k], original);
    else
      original = order[k];
  }
  return any;
}

template <typename Real>
void PointGrid<Real>::remove_repetitions(Level& level) {
  std::vector<std::uint8_t> repeated;
  std::uint32_t kept = 0;
  std::uint32_t first = 0;
  for (std::size_t cell = 0; cell + 1 < level.start.size(); ++cell) {
    const std::uint32_t last = level.start[cell + 1];
    const bool any = last - first > 1 && keep_first_of_equals(first, last, repeated);
    level.start[cell] = kept;
    if (!any && kept == first) {
      kept = last;
    } else {
      for (std::uint32_t i = first; i < last; ++i) {
        if (any && repeated[i - first]) continue;
        points_[kept] = points_[i];
        index_[kept++] = index_[i];
      }
    }
    first = last;
  }
  level.start.back() = kept;
  points_.resize(kept + padding);
  index_.resize(kept);
  std::sort(repetitions_.begin(), repetitions_.end(),
            [](const Repetition& a, const Repetition& b) { return a.index < b.index; });
}

/// Makes a grid of every cell with too many points. The points are distinct, so that each grid parts them.
template <typename Real>
void PointGrid<Real>::refine(std::size_t level) {
  for (std::uint32_t cell = 0; cell + 1 < levels_[level].start.size(); ++cell) {
    const std::uint32_t first = levels_[level].start[cell], last = levels_[level].start[cell + 1];
    if (last - first <= most_in_cell) continue;
    const std::vector<Point> points(points_.begin() + first, points_.begin() + last);
    const std::vector<std::uint32_t> index(index_.begin() + first, index_.begin() + last);
    Level finer = make_level(points);
    sort_into_cells(finer, points, index, first);
    levels_[level].children.push_back({cell, static_cast<std::uint32_t>(levels_.size())});
    levels_.push_back(std::move(finer));
  }
}

template class PointGrid<double>;
template class PointGrid<long double>;

}  // namespace rbpa
