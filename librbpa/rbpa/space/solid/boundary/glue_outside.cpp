#include "rbpa/space/solid/boundary/glue_outside.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rbpa/base/triangle.h"
#include "rbpa/space/surface/facing_sides.h"

namespace rbpa::space {
namespace {

/// Calls put(from, to, triangle, across) for each side with from < to: once for each wedge of tetrahedra at an edge.
template <typename Put>
void for_each_rising_side(const std::vector<Triangle>& triangles, const Put& put) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    if (a < b) put(a, b, t, 2u);
    if (b < c) put(b, c, t, 0u);
    if (c < a) put(c, a, t, 1u);
  }
}

}  // namespace

std::size_t glue_outside(std::span<const Point3> points, Surface& boundary) {
  const std::vector<Triangle>& triangles = boundary.triangles;
  /// A side of a triangle that leads to point `to`, across from corner `across`.
  struct Side {
    std::uint32_t to, triangle, across;
  };
  // Group the sides by their point `from`.
  std::vector<std::uint32_t> end(points.size() + 1, 0);
  for_each_rising_side(triangles, [&](std::uint32_t from, auto...) { ++end[from + 1]; });
  for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
  std::vector<Side> rising(end.back());
  for_each_rising_side(triangles, [&](std::uint32_t from, std::uint32_t to, std::uint32_t t, std::uint32_t k) {
    rising[end[from]++] = {to, t, k};
  });

  std::size_t shared = 0;
  std::vector<EdgeSide> sides;
  const auto add = [&](std::uint32_t t, std::uint32_t k) {
    const Triangle& corners = triangles[t];
    sides.push_back({corners[(k + 1) % 3], corners[(k + 2) % 3], corners[k], t, k});
  };
  // Now the sides of point i begin at end[i − 1], or at 0, and end at end[i].
  for (std::size_t i = 0, begin = 0; i < points.size(); begin = end[i++]) {
    const auto of = std::span(rising).subspan(begin, end[i] - begin);
    std::sort(of.begin(), of.end(), [](const Side& s, const Side& t) { return s.to < t.to; });
    for (std::size_t j = 0; j < of.size(); ++j) {
      const bool is_first = j == 0 || of[j - 1].to != of[j].to;
      if (is_first && (j + 1 == of.size() || of[j + 1].to != of[j].to)) continue;
      shared += is_first ? 0 : 1;
      const auto [to, t, k] = of[j];
      add(t, k);
      const std::uint32_t other = boundary.neighbors[t][k];
      add(other, (place_of(to, triangles[other]) + 2) % 3);
    }
  }
  for (const auto& [i, j] : facing_sides(points, sides)) {
    const EdgeSide &s = sides[i], &t = sides[j];
    boundary.neighbors[s.triangle][s.across] = t.triangle;
    boundary.neighbors[t.triangle][t.across] = s.triangle;
  }
  return shared;
}

}  // namespace rbpa::space
