#include "rbpa/plane/voronoi/cell_ridges.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rbpa {

CellRidges::CellRidges(const Delaunay& delaunay, Steps& step)
    : delaunay_(delaunay), along_(delaunay.triangulation().isolated) {
  const std::vector<Triangle>& triangles = delaunay_.triangulation().triangles;
  const std::vector<Triangle>& neighbors = delaunay_.triangulation().neighbors;
  if (triangles.empty()) {
    sort(along_, step, [&](auto a, auto b) { return point(a) < point(b); });
    begin_.assign(delaunay.points().size(), no_index);
    for (std::uint32_t i = 0; i < along_.size(); ++i) begin_[along_[i]] = i;
    return;
  }
  begin_.assign(delaunay.points().size() + 2, 0);
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t corner : triangle) ++begin_[corner + std::size_t{2}];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  // While corners are put in place, begin_[p + 1] is where the next corner at p goes.
  const auto place = [&](std::uint32_t p) -> std::uint32_t& { return begin_[p + std::size_t{1}]; };
  corners_.resize(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    step();
    if (constexpr std::size_t ahead = 24; t + ahead < triangles.size())
      for (const std::uint32_t corner : triangles[t + ahead]) __builtin_prefetch(&corners_[place(corner)], 1);
    const auto& [a, b, c] = triangles[t];
    corners_[place(a)++] = {b, c, t};
    corners_[place(b)++] = {c, a, t};
    corners_[place(c)++] = {a, b, t};
  }
  const auto fan = [&](std::uint32_t p) { return std::span(corners_).subspan(begin_[p], begin_[p + 1] - begin_[p]); };
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (neighbors[t][(k + 2) % 3] == no_index)  // the first triangle at a point of the hull
        for (Corner& corner : fan(triangles[t][k]))
          if (corner.triangle == t) std::swap(corner, fan(triangles[t][k]).front());
  std::vector<Corner> by_before;
  for (std::uint32_t p = 0; p < delaunay.points().size(); ++p) {
    step();
    put_in_order(fan(p), by_before);
  }
}

/// Puts the corners at a point in counter-clockwise order; the first one stays.
void CellRidges::put_in_order(std::span<Corner> fan, std::vector<Corner>& by_before) {
  constexpr std::size_t few = 24;  // corners up to which a linear search is faster
  if (fan.size() <= few) {
    for (std::size_t i = 1; i + 1 < fan.size(); ++i) {
      std::size_t j = i;
      while (j + 1 < fan.size() && fan[j].before != fan[i - 1].after) ++j;
      std::swap(fan[i], fan[j]);
    }
    return;
  }
  const auto is_before = [](const Corner& a, const Corner& b) { return a.before < b.before; };
  by_before.assign(fan.begin(), fan.end());
  std::sort(by_before.begin(), by_before.end(), is_before);
  for (std::size_t i = 1; i < fan.size(); ++i) {
    const Corner next = {fan[i - 1].after, no_index, no_index};
    const auto found = std::lower_bound(by_before.begin(), by_before.end(), next, is_before);
    if (found == by_before.end()) return;
    fan[i] = *found;
  }
}

}  // namespace rbpa
