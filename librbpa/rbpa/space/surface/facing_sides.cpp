#include "rbpa/space/surface/facing_sides.h"

#include <algorithm>
#include <tuple>

#include "rbpa/space/predicate/orientation.h"

namespace rbpa {
namespace {

std::pair<std::uint32_t, std::uint32_t> ends(const EdgeSide& side) {
  return {std::min(side.from, side.to), std::max(side.from, side.to)};
}
/// Returns whether the positive side of the triangle comes after the side, counter-clockwise about the direction from
/// the lower end of the edge to the higher end.
bool opens(const EdgeSide& side) { return side.from < side.to; }

/// Sorts the sides of one edge counter-clockwise, starting from the first side.
void sort_around(std::span<const Point3> points, std::span<EdgeSide> sides) {
  const auto [low, high] = ends(sides.front());
  const Point3 &a = points[low], &b = points[high], &start = points[sides.front().apex];
  const auto half = [&](const EdgeSide& side) { return -space::orientation(a, b, start, points[side.apex]); };
  std::sort(sides.begin() + 1, sides.end(), [&](const EdgeSide& s, const EdgeSide& t) {
    const int first = half(s), second = half(t);
    if (first != second) return first < second;
    return space::orientation(a, b, points[s.apex], points[t.apex]) > 0;
  });
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> facing_sides(std::span<const Point3> points,
                                                              std::vector<EdgeSide>& sides) {
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& s, const EdgeSide& t) {
    return std::tuple(ends(s), s.apex, s.triangle) < std::tuple(ends(t), t.apex, t.triangle);
  });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && ends(sides[last]) == ends(sides[first])) ++last;
    const std::size_t count = last - first;
    if (count > 2) sort_around(points, std::span(sides).subspan(first, count));
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t here = first + i, next = first + (i + 1) % count;
      if (opens(sides[here]) && !opens(sides[next])) pairs.emplace_back(here, next);
    }
  }
  return pairs;
}

}  // namespace rbpa
