#include "rbpa/plane/contours.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

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
void begin_at_least(std::vector<Point>& line) {
  const std::size_t n = line.size();
  std::size_t least = 0;
  for (std::size_t i = 1; i < n; ++i) {
    std::size_t k = 0;
    while (k < n && line[(i + k) % n] == line[(least + k) % n]) ++k;
    if (k < n && line[(i + k) % n] < line[(least + k) % n]) least = i;
  }
  std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(least), line.end());
}

/// The lines of one level. Each triangle that the level crosses has one segment, from the side that the line enters to
/// the side that it leaves.
class LinesOfLevel {
 public:
  /// `crossed` are the triangles with corners below and not below the level, ascending.
  LinesOfLevel(const Surface& surface, double level, std::span<const std::uint32_t> crossed)
      : surface_(surface), level_(level), crossed_(crossed), is_done_(crossed.size(), false) {}

  std::vector<Contour> find(std::size_t number) {
    std::vector<Contour> lines;
    const auto follow = [&](std::size_t i, bool is_closed) {
      Contour line{.level = number, .is_closed = is_closed, .points = line_from(i, is_closed)};
      if (line.points.size() > 1) lines.push_back(std::move(line));
    };
    for (std::size_t i = 0; i < crossed_.size(); ++i)
      if (surface_.of.neighbors[crossed_[i]][sides(crossed_[i]).entry] == no_index) follow(i, false);
    for (std::size_t i = 0; i < crossed_.size(); ++i)
      if (!is_done_[i]) follow(i, true);
    std::sort(lines.begin(), lines.end(), [](const Contour& a, const Contour& b) {
      return std::tie(a.points, a.is_closed) < std::tie(b.points, b.is_closed);
    });
    return lines;
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

  std::vector<Point> line_from(std::size_t i, bool is_closed) {
    std::vector<Point> line;
    const auto add = [&](const Point& point) {
      if (line.empty() || !(line.back() == point)) line.push_back(point);
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
    if (!is_closed) return line;
    while (line.size() > 1 && line.front() == line.back()) line.pop_back();
    begin_at_least(line);
    return line;
  }

  const Surface& surface_;
  double level_;
  std::span<const std::uint32_t> crossed_;
  std::vector<bool> is_done_;
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

std::vector<Contour> contours(std::span<const Point> points, const TriangleArrays& triangles,
                              std::span<const double> values, std::span<const double> levels,
                              const ContourOptions& options) {
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
  std::vector<std::vector<Contour>> lines(levels.size());
  Threads threads = threads_for(crossed.size(), options.threads);
  CheckpointOfThreads checkpoint(options.go_on);
  for_each_index(threads, levels.size(), [&](std::size_t level) {
    checkpoint();
    const auto of_level =
        std::span<const std::uint32_t>(crossed).subspan(begin[level], begin[level + 1] - begin[level]);
    lines[level] = LinesOfLevel(surface, levels[level], of_level).find(level);
  });
  std::vector<Contour> all;
  for (std::vector<Contour>& of_level : lines)
    all.insert(all.end(), std::make_move_iterator(of_level.begin()), std::make_move_iterator(of_level.end()));
  return all;
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
