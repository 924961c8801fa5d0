#include "rbpa/plane/contours.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/input.h"

namespace rbpa {
namespace {

/// The values of points in triangles.
struct Surface {
  std::span<const Point> points;
  TriangleArrays of;
  std::span<const double> values;
};

/// Rotates a closed line so that it begins at its least point; if it passes this point several times, so that the whole
/// line is least.
void begin_at_least(std::span<Point> line) {
  const std::size_t n = line.size();
  std::size_t least = 0;
  for (std::size_t i = 1; i < n; ++i) {
    std::size_t k = 0;
    while (k < n && line[(i + k) % n] == line[(least + k) % n]) ++k;
    if (k < n && line[(i + k) % n] < line[(least + k) % n]) least = i;
  }
  std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(least), line.end());
}

/// The lines of one level, in order. The points of a line follow each other in `points`.
struct FoundLines {
  struct Line {
    std::size_t begin, size;
    bool is_closed;
  };
  std::vector<Line> lines = {};
  std::vector<Point> points = {};
  std::span<const Point> points_of(const Line& line) const { return std::span(points).subspan(line.begin, line.size); }
};

/// Finds the lines of one level. Each triangle that the level crosses has one segment, from the side that the line
/// enters to the side that it leaves.
class LinesOfLevel {
 public:
  /// `crossed` are the triangles with corners below and not below the level, ascending.
  LinesOfLevel(const Surface& surface, double level, std::span<const std::uint32_t> crossed)
      : surface_(surface), level_(level), crossed_(crossed), is_done_(crossed.size(), false) {}

  FoundLines find() && {
    const auto follow = [&](std::size_t i, bool is_closed) {
      const std::size_t begin = found_.points.size();
      add_line(i, is_closed);
      const std::size_t size = found_.points.size() - begin;
      if (size > 1)
        found_.lines.push_back({begin, size, is_closed});
      else
        found_.points.resize(begin);
    };
    for (std::size_t i = 0; i < crossed_.size(); ++i)
      if (surface_.of.neighbors[crossed_[i]][sides(crossed_[i]).entry] == no_index) follow(i, false);
    for (std::size_t i = 0; i < crossed_.size(); ++i)
      if (!is_done_[i]) follow(i, true);
    using Line = FoundLines::Line;
    std::sort(found_.lines.begin(), found_.lines.end(), [&](const Line& a, const Line& b) {
      const auto p = found_.points_of(a), q = found_.points_of(b);
      const auto [at, other] = std::mismatch(p.begin(), p.end(), q.begin(), q.end());
      if (at == p.end() && other == q.end()) return a.is_closed < b.is_closed;
      return other != q.end() && (at == p.end() || *at < *other);
    });
    return std::move(found_);
  }

 private:
  /// The sides of a triangle that the line crosses, each by the corner across from it.
  struct Sides {
    std::size_t entry, exit;
  };

  bool is_above(std::uint32_t point) const { return surface_.values[point] >= level_; }

  Sides sides(std::uint32_t t) const {
    const Triangle& corners = surface_.of.triangles[t];
    std::size_t lone = 0;  // the corner that the line separates from the two others
    while (is_above(corners[lone]) == is_above(corners[(lone + 1) % 3]) ||
           is_above(corners[lone]) == is_above(corners[(lone + 2) % 3]))
      ++lone;
    const std::size_t next = (lone + 1) % 3, last = (lone + 2) % 3;
    return is_above(corners[lone]) ? Sides{last, next} : Sides{next, last};
  }

  /// Returns the point of the level on the side of triangle t across from corner k.
  Point crossing(std::uint32_t t, std::size_t k) const {
    std::uint32_t below = surface_.of.triangles[t][(k + 1) % 3], above = surface_.of.triangles[t][(k + 2) % 3];
    if (is_above(below)) std::swap(below, above);
    const double from = surface_.values[below] / 2, to = surface_.values[above] / 2;  // the difference stays finite
    const double share = surface_.values[above] == level_ ? 1 : std::min(1.0, (level_ / 2 - from) / (to - from));
    const Point &a = surface_.points[below], &b = surface_.points[above];
    return {std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share)};
  }

  /// Appends the points of the line that passes triangle crossed_[i], or enters there.
  void add_line(std::size_t i, bool is_closed) {
    std::vector<Point>& points = found_.points;
    const std::size_t begin = points.size();
    const auto add = [&](const Point& point) {
      if (points.size() == begin || !(points.back() == point)) points.push_back(point);
    };
    if (!is_closed) add(crossing(crossed_[i], sides(crossed_[i]).entry));
    while (!is_done_[i]) {
      is_done_[i] = true;
      const std::uint32_t t = crossed_[i];
      const std::size_t exit = sides(t).exit;
      add(crossing(t, exit));
      const std::uint32_t next = surface_.of.neighbors[t][exit];
      if (next == no_index) break;
      i = static_cast<std::size_t>(std::lower_bound(crossed_.begin(), crossed_.end(), next) - crossed_.begin());
    }
    if (!is_closed) return;
    while (points.size() > begin + 1 && points[begin] == points.back()) points.pop_back();
    begin_at_least(std::span(points).subspan(begin));
  }

  const Surface& surface_;
  double level_;
  std::span<const std::uint32_t> crossed_;
  std::vector<bool> is_done_;
  FoundLines found_;
};

void check_values(std::span<const Point> points, std::span<const double> values, std::span<const double> levels) {
  if (values.size() != points.size())
    throw InvalidInput("values: found " + std::to_string(values.size()) + " numbers, expected one for each of the " +
                       std::to_string(points.size()) + " points");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw InvalidInput("values: value " + std::to_string(i) + " is " + text(values[i]) +
                         ", expected a finite number");
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (!std::isfinite(levels[i]) || (i > 0 && !(levels[i - 1] < levels[i])))
      throw InvalidInput("levels: level " + std::to_string(i) + " is " + text(levels[i]) +
                         ", expected finite numbers in ascending order");
}

}  // namespace

Contours contours(std::span<const Point> points, const TriangleArrays& triangles, std::span<const double> values,
                  std::span<const double> levels, const ContourOptions& options) {
  check_values(points, values, levels);
  require_linked(triangles, points.size(), options.go_on);
  // Calls visit(level) for each level that crosses triangle t: the levels above its least value, up to its greatest.
  meshops::Steps steps(options.go_on);
  const auto for_each_level = [&](std::uint32_t t, auto visit) {
    steps();
    const auto [a, b, c] = triangles.triangles[t];
    const auto [least, greatest] = std::minmax({values[a], values[b], values[c]});
    auto level = std::upper_bound(levels.begin(), levels.end(), least);
    for (; level != levels.end() && *level <= greatest; ++level)
      visit(static_cast<std::size_t>(level - levels.begin()));
  };
  const auto count = static_cast<std::uint32_t>(triangles.triangles.size());
  std::vector<std::size_t> begin(levels.size() + 1, 0);
  for (std::uint32_t t = 0; t < count; ++t) for_each_level(t, [&](std::size_t level) { ++begin[level + 1]; });
  for (std::size_t level = 0; level < levels.size(); ++level) begin[level + 1] += begin[level];
  std::vector<std::uint32_t> crossed(begin.back());
  std::vector<std::size_t> next = begin;
  for (std::uint32_t t = 0; t < count; ++t) for_each_level(t, [&](std::size_t level) { crossed[next[level]++] = t; });

  const Surface surface{points, triangles, values};
  std::vector<FoundLines> found(levels.size());
  Threads threads = threads_for(crossed.size(), options.threads);
  CheckpointOfThreads checkpoint(options.go_on);
  for_each_index(threads, levels.size(), [&](std::size_t level) {
    checkpoint();
    const auto of_level =
        std::span<const std::uint32_t>(crossed).subspan(begin[level], begin[level + 1] - begin[level]);
    found[level] = LinesOfLevel(surface, levels[level], of_level).find();
  });
  std::size_t lines = 0, corners = 0;
  for (const FoundLines& of_level : found) {
    lines += of_level.lines.size();
    corners += of_level.points.size();
  }
  std::vector<Contour> all;
  std::vector<Point> all_points;
  all.reserve(lines);
  all_points.reserve(corners);  // so that the points stay where they are
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const FoundLines of_level = std::exchange(found[level], {});
    for (const FoundLines::Line& line : of_level.lines) {
      steps();
      const auto from = of_level.points_of(line);
      all_points.insert(all_points.end(), from.begin(), from.end());
      all.push_back({level, line.is_closed, std::span<const Point>(all_points).last(from.size())});
    }
  }
  return {std::move(all), std::move(all_points)};
}

std::vector<double> levels_every(double step, std::span<const double> values) {
  if (!(step > 0 && std::isfinite(step)))
    throw InvalidInput("step: found " + text(step) + ", expected a finite number above 0");
  std::vector<double> levels;
  if (values.empty()) return levels;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  constexpr double most = 100'000;
  const double first = std::floor(*least / step), last = std::ceil(*greatest / step);
  if (!(last - first <= most && std::max(std::abs(first), std::abs(last)) < 0x1p52))
    throw InvalidInput("step: found " + text(step) + ", which makes " + text(last - first) +
                       " levels here, expected a step with at most 100000");
  for (double k = first; k <= last; ++k)
    if (const double level = k * step; level > *least && level <= *greatest) levels.push_back(level + 0.0);  // no −0
  return levels;
}

}  // namespace rbpa
