#include "rbpa/space/repair/closing/links_of_triangles.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/repair/closing/triangle_sides.h"

namespace rbpa::space {
namespace {

/// Returns, for each triangle of vertices, the neighbors with which it shares a side: number k is across from corner k.
std::vector<Triangle> neighbors_of(std::span<const Triangle> triangles, meshops::Steps& step) {
  std::vector<Triangle> neighbors(triangles.size(), {no_index, no_index, no_index});
  const std::vector<TriangleSide> sides = sorted_sides(triangles, {}, step);
  const auto is_before = [](const TriangleSide& s, const TriangleSide& t) {
    return std::tie(s.from, s.to) < std::tie(t.from, t.to);
  };
  for (const TriangleSide& side : sides) {
    step(2);
    const auto [first, last] =
        std::equal_range(sides.begin(), sides.end(), TriangleSide{side.to, side.from, 0, 0}, is_before);
    if (last - first != 1) continue;
    const auto [own, own_end] = std::equal_range(sides.begin(), sides.end(), side, is_before);
    if (own_end - own != 1) continue;
    const Triangle& corners = triangles[side.triangle];
    const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), side.across) - corners.begin());
    neighbors[side.triangle][k] = first->triangle;
  }
  return neighbors;
}

}  // namespace

LinkedTriangles linked_triangles(std::span<const Triangle> of_vertices, std::span<const std::uint32_t> point,
                                 meshops::Steps& step) {
  std::vector<Triangle> triangles, neighbors = neighbors_of(of_vertices, step);
  for (std::size_t t = 0; t < of_vertices.size(); ++t) {
    Triangle corners = of_vertices[t];
    for (std::uint32_t& corner : corners) corner = point[corner];
    const auto least = std::min_element(corners.begin(), corners.end()) - corners.begin();
    std::rotate(corners.begin(), corners.begin() + least, corners.end());
    std::rotate(neighbors[t].begin(), neighbors[t].begin() + least, neighbors[t].end());
    triangles.push_back(corners);
  }
  LinkedTriangles result;
  result.order.resize(triangles.size());
  std::iota(result.order.begin(), result.order.end(), std::uint32_t{0});
  sort(result.order, step, [&](std::uint32_t t, std::uint32_t u) {
    return triangles[t] != triangles[u] ? triangles[t] < triangles[u] : t < u;
  });
  std::vector<std::uint32_t> number(triangles.size());
  for (std::uint32_t place = 0; place < number.size(); ++place) number[result.order[place]] = place;
  for (const std::uint32_t t : result.order) {
    for (std::uint32_t& other : neighbors[t])
      if (other != no_index) other = number[other];
    result.triangles.push_back(triangles[t]);
    result.neighbors.push_back(neighbors[t]);
  }
  return result;
}

}  // namespace rbpa::space
