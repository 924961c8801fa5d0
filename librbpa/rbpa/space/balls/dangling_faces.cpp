#include "rbpa/space/balls/dangling_faces.h"

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/solid/boundary/check_triangulation.h"

namespace rbpa {
namespace {

Triangle ascending(const std::array<std::uint32_t, 4>& corners, std::size_t k) {
  Triangle t = {corners[space::outer_faces[k][0]], corners[space::outer_faces[k][1]],
                corners[space::outer_faces[k][2]]};
  std::sort(t.begin(), t.end());
  return t;
}

/// Returns the dangling faces of points in a plane: the simplices up to alpha that are in no larger one.
DanglingFaces flat_faces(const SolidFiltration& filtration, std::size_t points, double alpha) {
  DanglingFaces result;
  std::vector<bool> has_triangle(filtration.edges.size(), false), has_edge(points, false);
  for (std::size_t i = 0; i < filtration.triangles.size(); ++i) {
    if (filtration.triangle_alpha[i] > alpha) continue;
    result.triangles.push_back(filtration.triangles[i]);
    for (const std::uint32_t edge : filtration.edges_of[i]) has_triangle[edge] = true;
  }
  for (std::size_t i = 0; i < filtration.edges.size(); ++i) {
    if (filtration.edge_alpha[i] > alpha) continue;
    for (const std::uint32_t point : filtration.edges[i]) has_edge[point] = true;
    if (!has_triangle[i]) result.edges.push_back(filtration.edges[i]);
  }
  for (const std::uint32_t point : filtration.delaunay.isolated)
    if (!has_edge[point]) result.points.push_back(point);
  std::sort(result.triangles.begin(), result.triangles.end());
  std::sort(result.edges.begin(), result.edges.end());
  return result;
}

}  // namespace

DanglingFaces dangling_faces(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                             double alpha, unsigned wanted) {
  Threads threads = space::check_triangulation("dangling_faces", points, delaunay, radii, alpha, wanted);
  if (delaunay.simplices.empty() && delaunay.distinct > 1)
    return flat_faces(solid_filtration(points, {.threads = wanted}), points.size(), alpha);
  const space::Triangulated cells(points, delaunay);
  const space::FacesWithin faces(cells, radii, alpha, threads);
  DanglingFaces result;
  for (std::uint32_t t = 0; t < radii.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      if (faces.is_first(t, k) && faces.has_triangle(t, k) && faces.tetrahedra_at(t, k) == 0)
        result.triangles.push_back(ascending(delaunay.simplices[t], k));
  std::sort(result.triangles.begin(), result.triangles.end());

  const space::PointStars stars(cells);
  std::vector<std::uint8_t> has_edge(stars.bound(), 0);
  space::for_each_edge(
      cells, stars, threads,
      [&](std::uint32_t a, std::uint32_t b, std::span<const space::EdgeAt> ring) {
        const bool is_of_triangle = faces.has_triangle_at(ring);
        if (!is_of_triangle && !faces.has_edge_alone(ring)) return false;
        for (const std::uint32_t point : {a, b}) std::atomic_ref(has_edge[point]).store(1, std::memory_order_relaxed);
        return !is_of_triangle;
      },
      [&](std::uint32_t a, std::uint32_t b) {
        result.edges.push_back({a, b});
      });
  result.points = delaunay.isolated;
  for (std::uint32_t v = 0; v < stars.bound(); ++v)
    if (has_edge[v] == 0 && !stars[v].empty()) result.points.push_back(v);
  std::sort(result.points.begin(), result.points.end());
  return result;
}

}  // namespace rbpa
