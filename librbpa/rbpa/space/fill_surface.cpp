#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/fill_holes.h"
#include "rbpa/space/closing/triangle_sides.h"
#include "rbpa/split_fans.h"

namespace rbpa {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The vertex at the end of an edge, in the fan of the edge's triangle.
std::uint32_t vertex_at(const Surface& surface, const SplitFans& fans, std::uint32_t triangle, std::uint32_t point) {
  const Triangle& corners = surface.triangles[triangle];
  const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), point) - corners.begin());
  meshops::require(k < 3, "fill_holes: expected curves of this surface");
  return fans.triangles[triangle][k];
}

/// Of triangles of vertices: those that have a side in common, number k across from corner k.
std::vector<Triangle> neighbors_of(std::span<const Triangle> triangles) {
  std::vector<Triangle> neighbors(triangles.size(), {Surface::none, Surface::none, Surface::none});
  const std::vector<space::TriangleSide> sides = space::sorted_sides(triangles, {});
  const auto is_before = [](const space::TriangleSide& s, const space::TriangleSide& t) {
    return std::tie(s.from, s.to) < std::tie(t.from, t.to);
  };
  for (const space::TriangleSide& side : sides) {
    const auto [first, last] =
        std::equal_range(sides.begin(), sides.end(), space::TriangleSide{side.to, side.from, 0, 0}, is_before);
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

FilledSurface fill_holes(std::span<const Point3> points, const Surface& surface, std::span<const Hole> curves,
                         const SurfaceOptions& options) {
  const SplitFans fans = split_fans(surface);
  std::vector<Point3> places;
  places.reserve(fans.point.size());
  for (const std::uint32_t point : fans.point) {
    meshops::require(point < points.size(), "fill_holes: expected a surface of these points");
    places.push_back(points[point]);
  }
  std::vector<std::vector<std::uint32_t>> loops;
  for (const Hole& curve : curves) {
    std::vector<std::uint32_t>& loop = loops.emplace_back();
    for (const RimEdge& edge : curve.edges) {
      meshops::require(edge.triangle < surface.triangles.size(), "fill_holes: expected curves of this surface");
      loop.push_back(vertex_at(surface, fans, edge.triangle, edge.from));
    }
  }
  HoleFilling filling = fill_holes(places, fans.triangles, loops, options);

  FilledSurface result;
  result.holes = std::move(filling.loops);
  result.surface.duplicates = surface.duplicates;
  result.surface.distinct = surface.distinct;
  std::vector<Triangle> neighbors = neighbors_of(filling.triangles);
  // As points, each with its least first, in lexicographic order.
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < filling.triangles.size(); ++t) {
    Triangle corners = filling.triangles[t];
    for (std::uint32_t& corner : corners) corner = fans.point[corner];
    const auto least = std::min_element(corners.begin(), corners.end()) - corners.begin();
    std::rotate(corners.begin(), corners.begin() + least, corners.end());
    std::rotate(neighbors[t].begin(), neighbors[t].begin() + least, neighbors[t].end());
    triangles.push_back(corners);
  }
  std::vector<std::uint32_t> order(triangles.size()), number(triangles.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t t, std::uint32_t u) { return triangles[t] < triangles[u]; });
  for (std::uint32_t place = 0; place < order.size(); ++place) number[order[place]] = place;
  for (const std::uint32_t t : order) {
    for (std::uint32_t& other : neighbors[t])
      if (other != Surface::none) other = number[other];
    result.surface.triangles.push_back(triangles[t]);
    result.surface.neighbors.push_back(neighbors[t]);
    result.is_new.push_back(t >= surface.triangles.size());
  }
  return result;
}

}  // namespace rbpa
