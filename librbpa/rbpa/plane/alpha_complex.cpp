#include "rbpa/plane/alpha_complex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "rbpa/base/run/input.h"
#include "rbpa/plane/arrays/boundary_sides.h"
#include "rbpa/plane/arrays/keep_triangles.h"
#include "rbpa/plane/arrays/linked_triangles.h"
#include "rbpa/plane/arrays/outlined_triangles.h"
#include "rbpa/plane/arrays/triangle_list.h"
#include "rbpa/plane/collinear.h"
#include "rbpa/plane/divide/small_set.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/patches/find_triangles.h"
#include "rbpa/plane/predicate/radius.h"

namespace rbpa {
namespace {

std::vector<std::array<std::uint32_t, 2>> boundary_of(const AlphaComplex& of, const Checkpoint& checkpoint) {
  return boundary_sides(of, [&checkpoint, t = 0u]() mutable {
    if (t++ % (1u << 18) == 0 && checkpoint) checkpoint();
  });
}

void triangulate_on_tiles(std::span<const Point> points, double alpha, const AlphaComplexOptions& options,
                          AlphaComplex& result) {
  Threads threads = threads_for(points.size(), options.threads);
  std::optional<Sites> sites(std::in_place, points, threads, checkpoint_of(options.progress, points.size()));
  result.distinct = sites->size();
  result.duplicates = sites->duplicates();
  const bool are_on_a_line = are_collinear(points, go_on_of(options.progress, points.size()));
  const auto find = [&](auto& list) {
    if (!are_on_a_line) find_triangles(*sites, Radius::of(alpha), options.progress, threads, list);
  };
  const auto sort = [&](auto& list) {
    const Checkpoint checkpoint = checkpoint_of(options.progress, result.distinct, list.size());
    sites.reset();  // frees memory before the list becomes the result
    return list.sorted(threads, checkpoint);
  };
  if (options.neighbors) {
    LinkedTriangles list(sites->size(), sites->input_index(), points.size(), threads);
    find(list);
    OwnedTriangles sorted = sort(list);
    result.triangles = std::move(sorted.triangles);
    result.neighbors = std::move(sorted.neighbors);
  } else {
    TriangleList list(sites->size(), sites->input_index(), points.size(), threads);
    if (options.boundary) {
      OutlinedTriangles outlined(sites->size(), sites->input_index(), list);
      find(outlined);
      result.boundary = outlined.boundary();
    } else {
      find(list);
    }
    result.triangles = sort(list);
  }
  // If the radius is infinite and there is a triangle, all points are in triangles.
  if (are_on_a_line || std::isfinite(alpha)) result.isolated = isolated_in(result, points.size());
}

/// Computes the triangles of a radius, and the isolated points.
AlphaComplex solid_complex(std::span<const Point> points, double alpha, const AlphaComplexOptions& options) {
  AlphaComplex result;
  if (points.size() >= small_set_limit || !triangulate_small_set(points, alpha, options, result))
    triangulate_on_tiles(points, alpha, options, result);
  const Checkpoint checkpoint = checkpoint_of(options.progress, result.distinct, result.triangles.size());
  if (options.boundary && result.boundary.empty()) result.boundary = boundary_of(result, checkpoint);
  if (!options.neighbors) result.neighbors = std::vector<Triangle>();
  return result;
}

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

/// Returns the edges of the alpha complex that are in no triangle of the complex, in lexicographic order. An edge is in
/// the complex if a triangle at the edge is, or if its diametral circle is empty and of a radius ≤ alpha (Edelsbrunner,
/// Kirkpatrick, Seidel, 1983). Requires: `delaunay` is the solid complex at infinity, with neighbors.
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

/// Removes the triangles of circumradius > alpha, also from the neighbors; leaves `isolated` as it is.
void keep_within(std::span<const Point> points, double alpha, AlphaComplex& delaunay) {
  const Radius radius = Radius::of(alpha);
  keep_triangles(delaunay, [&](std::size_t t) {
    const auto [a, b, c] = delaunay.triangles[t];
    return radius.admits<Real>(points[a], points[b], points[c]);
  });
}

}  // namespace

AlphaComplex alpha_complex(std::span<const Point> points, double alpha, const AlphaComplexOptions& options) {
  check(points, alpha);
  if (options.complex == ComplexKind::solid) return solid_complex(points, alpha, options);
  AlphaComplexOptions of_delaunay = options;
  of_delaunay.neighbors = true;
  of_delaunay.boundary = false;
  AlphaComplex result = solid_complex(points, std::numeric_limits<double>::infinity(), of_delaunay);
  result.edges = dangling_edges(points, alpha, result);
  keep_within(points, alpha, result);
  result.isolated = isolated_in(result, points.size());
  std::vector<std::uint8_t> covered(points.size(), 1);
  for (const std::uint32_t i : result.isolated) covered[i] = 0;
  for (const auto& [a, b] : result.edges) covered[a] = covered[b] = 1;
  result.points = unmarked(covered, result.duplicates);
  if (options.boundary)
    result.boundary = boundary_of(result, checkpoint_of(options.progress, result.distinct, result.triangles.size()));
  if (!options.neighbors) result.neighbors = std::vector<Triangle>();
  return result;
}

}  // namespace rbpa
