#include "triangulation/surface_counts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "meshops/core/disjoint_sets.h"

namespace rbpa::app {
namespace {

using Index = std::uint32_t;

/// Sets of corners or sides: number 3 t + k is that of triangle t at k.
struct Sets : meshops::DisjointSets {
  explicit Sets(std::size_t size) : DisjointSets(size), count(size) {}
  void unite(std::size_t a, std::size_t b) { count -= join(static_cast<Index>(a), static_cast<Index>(b)); }
  Index of(std::size_t i) { return find(static_cast<Index>(i)); }
  std::size_t count;
};

/// Which side of the neighbour over side k of t is glued to that one: it has its ends the other way around.
std::size_t side_back(const Surface& surface, std::size_t t, std::size_t k) {
  const auto& here = surface.triangles[t];
  const Index neighbor = surface.neighbors[t][k];
  const auto& there = surface.triangles[neighbor];
  for (std::size_t m = 0; m < 3; ++m)
    if (there[(m + 1) % 3] == here[(k + 2) % 3] && there[(m + 2) % 3] == here[(k + 1) % 3] &&
        surface.neighbors[neighbor][m] == t)
      return m;
  return 3;
}

Sets components_of(const Surface& surface) {
  Sets components(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index neighbor : surface.neighbors[t])
      if (neighbor != Surface::none) components.unite(t, neighbor);
  return components;
}

/// Extreme coordinates may overflow: all is in units of the largest one.
struct Shell {
  std::array<double, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  double volume = 0;

  double diagonal() const { return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]); }
};

}  // namespace

SurfaceCounts count(const Surface& surface) {
  const std::size_t triangles = surface.triangles.size();
  Sets corners(3 * triangles), rims(3 * triangles);
  std::size_t glued = 0, boundary = 0;
  Index most = 0;
  for (std::size_t t = 0; t < triangles; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      most = std::max(most, surface.triangles[t][k]);
      const Index neighbor = surface.neighbors[t][k];
      if (neighbor == Surface::none) {
        ++boundary;
        continue;
      }
      ++glued;
      const std::size_t m = side_back(surface, t, k), there = std::size_t{neighbor} * 3;
      corners.unite(3 * t + (k + 1) % 3, there + (m + 2) % 3);
      corners.unite(3 * t + (k + 2) % 3, there + (m + 1) % 3);
    }
  // Two boundary sides follow each other where they meet at one fan, which has at most two.
  std::vector<std::size_t> rim_at(boundary ? 3 * triangles : 0, 3 * triangles);
  std::size_t curves = boundary;
  for (std::size_t t = 0; t < triangles && boundary; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      if (surface.neighbors[t][k] != Surface::none) continue;
      for (const std::size_t end : {(k + 1) % 3, (k + 2) % 3}) {
        std::size_t& other = rim_at[corners.of(3 * t + end)];
        if (other == 3 * triangles) {
          other = 3 * t + k;
        } else if (rims.of(other) != rims.of(3 * t + k)) {
          rims.unite(other, 3 * t + k);
          --curves;
        }
      }
    }
  std::vector<bool> used(triangles ? std::size_t{most} + 1 : 0);
  for (const auto& triangle : surface.triangles)
    for (const Index corner : triangle) used[corner] = true;

  SurfaceCounts counts{.triangles = triangles,
                       .points = static_cast<std::size_t>(std::count(used.begin(), used.end(), true)),
                       .vertices = corners.count,
                       .edges = glued / 2 + boundary,
                       .boundary_curves = curves,
                       .components = components_of(surface).count};
  // Euler: vertices - edges + triangles = 2 components - 2 genus - boundary curves.
  counts.genus = (2 * counts.components + counts.edges - counts.boundary_curves - counts.vertices - triangles) / 2;
  return counts;
}

std::vector<std::array<std::uint32_t, 3>> by_shells(std::span<const Point3> points, const Surface& surface) {
  double largest = 0;
  for (const Point3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (largest == 0) largest = 1;
  const auto place = [&](Index i) {
    return std::array<double, 3>{points[i].x / largest, points[i].y / largest, points[i].z / largest};
  };
  Sets components = components_of(surface);
  std::vector<Shell> shells(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& corners = surface.triangles[t];
    Shell& shell = shells[components.of(t)];
    for (const Index corner : corners) {
      const auto p = place(corner);
      for (std::size_t k = 0; k < 3; ++k) {
        shell.low[k] = std::min(shell.low[k], p[k]);
        shell.high[k] = std::max(shell.high[k], p[k]);
      }
    }
    const auto a = place(corners[0]), b = place(corners[1]), c = place(corners[2]);
    shell.volume +=
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  std::vector<std::size_t> first(surface.triangles.size(), surface.triangles.size());  // triangle of each component
  for (std::size_t t = surface.triangles.size(); t-- > 0;) first[components.of(t)] = t;
  std::vector<std::size_t> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t t) {
    const std::size_t c = components.of(t);
    return std::make_tuple(-shells[c].diagonal(), -shells[c].volume, first[c], t);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(order.size());
  for (const std::size_t t : order) triangles.push_back(surface.triangles[t]);
  return triangles;
}

}  // namespace rbpa::app
