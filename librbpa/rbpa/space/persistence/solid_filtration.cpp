#include "rbpa/space/persistence/solid_filtration.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/persistence/pairing/beside_flat.h"
#include "rbpa/space/persistence/pairing/number_faces.h"
#include "rbpa/space/persistence/pairing/triangle_radii.h"
#include "rbpa/space/predicate/least_sphere.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/insertion/spatial_order.h"
#include "rbpa/space/solid/solid_radii.h"

namespace rbpa {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t at_a_time = 1u << 12;

std::vector<std::uint32_t> order_on_curve(std::span<const Point3> points, const Checkpoint& checkpoint) {
  const space::Spread spread = space::spread(points);
  std::vector<Point3> copy;
  return space::order_on_curve(points, space::scaled(points, spread, copy), checkpoint);
}

/// Returns the corner of a triangle that is inside the least sphere of the other two, at most one; 3 if there is none.
std::uint8_t obtuse_corner(std::span<const Point3> points, const Triangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k)
    if (space::in_least_sphere(points[triangle[(k + 1) % 3]], points[triangle[(k + 2) % 3]], points[triangle[k]]))
      return static_cast<std::uint8_t>(k);
  return 3;
}

/// Fills in edge_alpha: the radius of an edge's least sphere if no corner of the triangles at the edge is inside; else
/// the least radius of these triangles.
void find_alpha_of_edges(std::span<const Point3> points, Threads& threads, Steps& step, SolidFiltration& filtration) {
  const auto& triangles = filtration.triangles;
  std::vector<std::uint8_t> obtuse(triangles.size());
  for_each_part(threads, triangles.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) obtuse[i] = obtuse_corner(points, triangles[i]);
  });
  std::vector<std::uint8_t> is_alone(filtration.edges.size(), 1);
  auto& alpha = filtration.edge_alpha;
  alpha.assign(filtration.edges.size(), infinity);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    step();
    for (const std::uint32_t edge : filtration.edges_of[i])
      alpha[edge] = std::min(alpha[edge], filtration.triangle_alpha[i]);
    if (obtuse[i] < 3) is_alone[filtration.edges_of[i][obtuse[i]]] = 0;
  }
  for_each_part(threads, alpha.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (is_alone[i] != 0)
        alpha[i] = space::least_radius_rounded_up(points[filtration.edges[i][0]], points[filtration.edges[i][1]]);
  });
}

/// Keeps the rows whose corners are all below `points`. Returns the new number of each row.
template <typename Rows>
std::vector<std::uint32_t> keep_below(std::size_t points, Rows& rows) {
  std::vector<std::uint32_t> number(rows.size(), Solid::none);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (std::any_of(rows[i].begin(), rows[i].end(), [&](std::uint32_t corner) { return corner >= points; })) continue;
    number[i] = kept;
    rows[kept++] = rows[i];
  }
  rows.resize(kept);
  return number;
}

/// Fills in triangles, with radii, and edges of points without a tetrahedron, from the base of a cone over the points.
void take_flat(std::span<const Point3> points, const SolidOptions& options, Threads& threads, Steps& step,
               SolidFiltration& filtration) {
  std::vector<Point3> cone(points.begin(), points.end());
  for (const Point3& apex : space::beside_flat(points)) cone.push_back(apex);
  const Solid solid_of_cone =
      solid(cone, infinity, {.neighbors = true, .threads = options.threads, .progress = options.progress});
  filtration.triangles = space::number_triangles(solid_of_cone, step).corners;
  space::NumberedEdges edges = space::number_edges(cone.size(), filtration.triangles, step);
  filtration.edges = std::move(edges.ends);
  const std::vector<std::uint32_t> number = keep_below(points.size(), filtration.edges);
  const std::vector<std::uint32_t> kept = keep_below(points.size(), filtration.triangles);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] == Solid::none) continue;
    for (std::uint32_t& edge : edges.of[i]) edge = number[edge];
    filtration.edges_of.push_back(edges.of[i]);
  }
  filtration.triangle_alpha.resize(filtration.triangles.size());
  for_each_part(threads, filtration.triangles.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [a, b, c] = filtration.triangles[i];
      filtration.triangle_alpha[i] = space::LeastSphere(points[a], points[b], points[c]).radius_rounded_up();
    }
  });
}

/// Renames the corners from places on the curve to input indices.
void rename_corners(std::span<const std::uint32_t> index, SolidFiltration& filtration) {
  Solid& delaunay = filtration.delaunay;
  for (auto& row : delaunay.simplices)
    for (std::uint32_t& corner : row) corner = index[corner];
  for (std::uint32_t& point : delaunay.isolated) point = index[point];
  std::sort(delaunay.isolated.begin(), delaunay.isolated.end());
  for (Duplicate& duplicate : delaunay.duplicates) duplicate = {index[duplicate.index], index[duplicate.stands_for]};
  std::sort(delaunay.duplicates.begin(), delaunay.duplicates.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.index < b.index; });
  for (std::size_t i = 0; i < filtration.triangles.size(); ++i) {
    auto& corners = filtration.triangles[i];
    auto& across = filtration.edges_of[i];
    for (std::uint32_t& corner : corners) corner = index[corner];
    for (const auto& [k, l] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(0u, 1u)})
      if (corners[k] > corners[l]) {
        std::swap(corners[k], corners[l]);
        std::swap(across[k], across[l]);
      }
  }
  for (auto& [a, b] : filtration.edges) {
    a = index[a];
    b = index[b];
    if (a > b) std::swap(a, b);
  }
}

}  // namespace

/// Computes the filtration:
///   1. sort the points along a curve, and triangulate them as if they had been numbered so;
///   2. number triangles and edges;
///   3. find the radii of tetrahedra, triangles and edges;
///   4. rename the corners.
SolidFiltration solid_filtration(std::span<const Point3> points, const SolidOptions& options) {
  space::check_points(points);
  const std::vector<std::uint32_t> index = order_on_curve(points, checkpoint_of(options.progress, points.size()));
  std::vector<Point3> sorted(points.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = points[index[i]];

  SolidFiltration filtration;
  Solid& delaunay = filtration.delaunay;
  delaunay = solid(sorted, infinity, {.neighbors = true, .threads = options.threads, .progress = options.progress});
  const GoOn go_on = [&] { return !options.progress || options.progress({delaunay.distinct, delaunay.distinct}); };
  Steps step(go_on);
  Threads threads = threads_for(points.size(), options.threads);
  if (delaunay.simplices.empty() && delaunay.distinct > 1) {
    take_flat(sorted, options, threads, step, filtration);
  } else {
    space::NumberedTriangles triangles = space::number_triangles(delaunay, step);
    space::NumberedEdges edges = space::number_edges(sorted.size(), triangles.corners, step);
    filtration.tetrahedron_alpha = circumradii(sorted, delaunay.simplices, options.threads, go_on);
    filtration.triangle_alpha =
        space::triangle_radii(sorted, delaunay, filtration.tetrahedron_alpha, triangles, threads, go_on);
    filtration.triangles = std::move(triangles.corners);
    filtration.triangles_of = std::move(triangles.of);
    filtration.edges = std::move(edges.ends);
    filtration.edges_of = std::move(edges.of);
  }
  find_alpha_of_edges(sorted, threads, step, filtration);
  rename_corners(index, filtration);
  return filtration;
}

}  // namespace rbpa
