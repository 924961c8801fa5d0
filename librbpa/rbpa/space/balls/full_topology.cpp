#include "rbpa/space/balls/full_topology.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/outside_of_balls.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/solid/boundary/check_triangulation.h"
#include "rbpa/space/solid/boundary/solid_part.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_components.h"

namespace rbpa {
namespace {

/// Returns the sets of tetrahedra that are not in the complex and are connected outside of it. One more element, after
/// the tetrahedra, is the outside of the triangulation.
meshops::DisjointSets connected_outside(const Solid& delaunay, const space::FacesWithin& faces, const GoOn& go_on) {
  Steps step(go_on);
  const auto count = static_cast<std::uint32_t>(delaunay.simplices.size());
  meshops::DisjointSets sets(std::size_t{count} + 1);
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      step();
      if (!faces.is_first(t, k) || faces.has_triangle(t, k)) continue;
      const std::uint32_t beyond = delaunay.neighbors[t][k];
      sets.join(t, beyond == Solid::none ? count : beyond);
    }
  return sets;
}

/// Counts the simplices of points in a plane.
FullCounts count_flat(std::span<const Point3> points, double alpha, unsigned threads) {
  const SolidFiltration filtration = solid_filtration(points, {.threads = threads});
  FullCounts counts;
  counts.points = counts.components = filtration.delaunay.distinct;
  meshops::DisjointSets sets(points.size());
  for (std::size_t i = 0; i < filtration.edges.size(); ++i) {
    if (filtration.edge_alpha[i] > alpha) continue;
    ++counts.edges;
    counts.components -= sets.join(filtration.edges[i][0], filtration.edges[i][1]) ? 1U : 0U;
  }
  for (const double radius : filtration.triangle_alpha) counts.triangles += radius <= alpha ? 1U : 0U;
  counts.tunnels = counts.components + counts.edges - counts.points - counts.triangles;
  return counts;
}

/// Returns the number of pieces of a void's walls, connected through points.
std::size_t pieces(const Surface& boundary, const SolidVoid& hollow) {
  meshops::DisjointSets sets(hollow.points.size());
  const auto number = [&](std::uint32_t point) {
    const auto at = std::lower_bound(hollow.points.begin(), hollow.points.end(), point);
    return static_cast<std::uint32_t>(at - hollow.points.begin());
  };
  std::size_t count = hollow.points.size();
  for (const std::uint32_t t : hollow.triangles)
    for (std::size_t k = 1; k < 3; ++k)
      count -= sets.join(number(boundary.triangles[t][0]), number(boundary.triangles[t][k])) ? 1U : 0U;
  return count;
}

/// Counts the simplices of a complex. `sets` is connected_outside().
FullCounts count(const space::Triangulated& cells, const space::FacesWithin& faces, meshops::DisjointSets& sets,
                 std::size_t distinct, Threads& threads, const GoOn& go_on) {
  FullCounts counts;
  counts.points = distinct;
  const auto outside = static_cast<std::uint32_t>(cells.simplices.size());
  for (std::uint32_t t = 0; t < outside; ++t) {
    const bool is_in = faces.has_tetrahedron(t);
    counts.tetrahedra += is_in ? 1U : 0U;
    for (std::size_t k = 0; k < 4; ++k) counts.triangles += faces.is_first(t, k) && faces.has_triangle(t, k) ? 1U : 0U;
    counts.voids += !is_in && sets.is_least(t) && sets.find(outside) != t ? 1U : 0U;
  }
  const space::EdgeCounts edges = space::count_edges(
      cells, threads, [&](std::span<const space::EdgeAt> ring) { return faces.has_edge(ring); }, go_on);
  counts.edges = edges.edges;
  counts.components = counts.points - edges.joined;
  // Euler's formula: points − edges + triangles − tetrahedra = components − tunnels + voids.
  counts.tunnels =
      counts.components + counts.voids + counts.edges + counts.tetrahedra - counts.points - counts.triangles;
  return counts;
}

/// Returns the tetrahedra in voids of a complex. `sets` is connected_outside().
Solid in_voids(const Solid& delaunay, const space::FacesWithin& faces, meshops::DisjointSets& sets, Threads& threads) {
  const auto outside = static_cast<std::uint32_t>(delaunay.simplices.size());
  std::vector<std::uint32_t> kept;
  for (std::uint32_t t = 0; t < outside; ++t)
    if (!faces.has_tetrahedron(t) && sets.find(t) != sets.find(outside)) kept.push_back(t);
  return space::part_of(delaunay, kept, threads,
                        [&](std::uint32_t t, std::size_t k) { return !faces.has_triangle(t, k); });
}

}  // namespace

FullCounts count_full(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                      double alpha, unsigned wanted, const GoOn& go_on) {
  Threads threads = space::check_triangulation("count_full", points, delaunay, radii, alpha, wanted);
  if (delaunay.simplices.empty() && delaunay.distinct > 1) return count_flat(points, alpha, wanted);
  const space::Triangulated cells(points, delaunay);
  const space::FacesWithin faces(cells, radii, alpha, threads, go_on);
  meshops::DisjointSets sets = connected_outside(delaunay, faces, go_on);
  return count(cells, faces, sets, delaunay.distinct, threads, go_on);
}

Solid void_space(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii, double alpha,
                 unsigned wanted, const GoOn& go_on) {
  Threads threads = space::check_triangulation("void_space", points, delaunay, radii, alpha, wanted);
  const space::FacesWithin faces({points, delaunay}, radii, alpha, threads, go_on);
  meshops::DisjointSets sets = connected_outside(delaunay, faces, go_on);
  return in_voids(delaunay, faces, sets, threads);
}

FullVoids full_voids(std::span<const Point3> points, const Solid& space, double alpha, unsigned wanted,
                     const GoOn& go_on) {
  SolidBoundary boundary = solid_boundary(space, wanted);
  const SolidComponents components = solid_components(points, space, boundary);
  FullVoids voids;
  Threads threads = threads_for(points.size(), wanted);
  const std::vector<double> outside =
      space::outside_of_balls({points, space}, components.number, components.all.size(), alpha, threads, go_on);
  for (std::size_t i = 0; i < components.all.size(); ++i) {
    const SolidComponent& c = components.all[i];
    voids.all.push_back({.triangles = {},
                         .points = {},
                         .islands = 0,
                         .volume = c.volume,
                         .outside_balls = outside[i],
                         .area = c.area,
                         .low = c.low,
                         .high = c.high});
  }
  voids.boundary = std::move(boundary.surface);
  for (std::uint32_t t = 0; t < boundary.tetrahedra.size(); ++t) {
    auto& corners = voids.boundary.triangles[t];
    SolidVoid& hollow = voids.all[components.number[boundary.tetrahedra[t]]];
    hollow.triangles.push_back(t);
    hollow.points.insert(hollow.points.end(), corners.begin(), corners.end());
    std::swap(corners[1], corners[2]);
    std::swap(voids.boundary.neighbors[t][1], voids.boundary.neighbors[t][2]);
  }
  for (SolidVoid& hollow : voids.all) {
    sort_unique(hollow.points);
    hollow.islands = pieces(voids.boundary, hollow) - 1;
  }
  return voids;
}

FullTopology full_topology(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                           double alpha, unsigned wanted, const GoOn& given) {
  Threads threads = space::check_triangulation("full_topology", points, delaunay, radii, alpha, wanted);
  CheckpointOfThreads checkpoint(given);
  const GoOn go_on = [&] { return checkpoint.goes_on(); };
  const space::Triangulated cells(points, delaunay);
  const space::FacesWithin faces(cells, radii, alpha, threads, go_on);
  meshops::DisjointSets sets = connected_outside(delaunay, faces, go_on);
  const Solid in_void = in_voids(delaunay, faces, sets, threads);
  FullTopology full;
  for_each_index(threads, 2, [&](std::size_t task) {
    if (task == 0)
      full.voids = full_voids(points, in_void, alpha, wanted, go_on);
    else if (delaunay.simplices.empty() && delaunay.distinct > 1)
      full.counts = count_flat(points, alpha, wanted);
    else
      full.counts = count(cells, faces, sets, delaunay.distinct, threads, go_on);
  });
  return full;
}

}  // namespace rbpa
