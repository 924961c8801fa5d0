#include "rbpa/plane/arrays/dangling.h"

#include <algorithm>

#include "rbpa/plane/arrays/keep_triangles.h"
#include "rbpa/plane/predicate/radius.h"

namespace rbpa {
namespace {

using Real = long double;  // fits any coordinates
using Edge = std::array<std::uint32_t, 2>;

/// Returns the edges of length ≤ 2 alpha between neighbors on a line.
std::vector<Edge> along_line(std::span<const Point> points, const Radius& radius, const AlphaComplex& of) {
  std::vector<std::uint32_t> order = of.isolated;
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; });
  std::vector<Edge> edges;
  for (std::size_t i = 1; i < order.size(); ++i)
    if (radius.spans<Real>(points[order[i - 1]], points[order[i]]))
      edges.push_back({std::min(order[i - 1], order[i]), std::max(order[i - 1], order[i])});
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

std::vector<Edge> dangling_edges(std::span<const Point> points, double alpha, const AlphaComplex& delaunay) {
  const Radius radius = Radius::of(alpha);
  if (delaunay.triangles.empty()) return along_line(points, radius, delaunay);
  const auto admits = [&](std::size_t t) {
    const auto& [a, b, c] = delaunay.triangles[t];
    return radius.admits<Real>(points[a], points[b], points[c]);
  };
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < delaunay.triangles.size(); ++t) {
    if (admits(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = delaunay.neighbors[t][k];
      if (other != AlphaComplex::none && (other < t || admits(other))) continue;
      const auto& corner = delaunay.triangles[t];
      const std::uint32_t a = corner[(k + 1) % 3], b = corner[(k + 2) % 3];
      // Seen from a point in the diametral circle, the edge subtends more than a right angle. If any point lies in the
      // circle, one of the two apexes does.
      const auto is_empty = [&](std::uint32_t apex) {
        return Predicates<Real>::dot_sign(points[apex], points[a], points[b]) >= 0;
      };
      if (!radius.spans<Real>(points[a], points[b]) || !is_empty(corner[k])) continue;
      if (other != AlphaComplex::none) {
        const auto& beyond = delaunay.triangles[other];
        const std::uint32_t apex = beyond[0] ^ beyond[1] ^ beyond[2] ^ a ^ b;
        if (!is_empty(apex)) continue;
      }
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void keep_within(std::span<const Point> points, double alpha, AlphaComplex& delaunay) {
  const Radius radius = Radius::of(alpha);
  keep_triangles(delaunay, [&](std::size_t t) {
    const auto [a, b, c] = delaunay.triangles[t];
    return radius.admits<Real>(points[a], points[b], points[c]);
  });
}

}  // namespace rbpa
