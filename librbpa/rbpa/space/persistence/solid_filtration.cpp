#include "rbpa/space/persistence/solid_filtration.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/cells/circumradii.h"
#include "rbpa/space/persistence/pairing/curve_order.h"
#include "rbpa/space/persistence/pairing/number_faces.h"
#include "rbpa/space/persistence/pairing/radius_rule.h"
#include "rbpa/space/persistence/pairing/values_of_faces.h"
#include "rbpa/space/predicate/beside_flat.h"

namespace rbpa {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

/// Fills in triangles, radii of triangles, and edges for points in a plane or on a line: those of the base of a cone
/// over the points.
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
  const space::RadiusRule rule(points);
  for_each_part(threads, filtration.triangles.size(), space::faces_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      filtration.triangle_alpha[i] = rule.triangle(filtration.triangles[i]).value();
  });
}

}  // namespace

/// Computes the filtration:
///   1. sort the points along a curve, and triangulate the points in this order;
///   2. number triangles and edges;
///   3. find the radii of tetrahedra, triangles and edges;
///   4. rename the corners.
SolidFiltration solid_filtration(std::span<const Point3> points, const SolidOptions& options) {
  space::check_points(points);
  Threads threads = threads_for(points.size(), options.threads);
  const space::CurveOrder order(points, threads, checkpoint_of(options.progress, points.size()));
  const std::vector<Point3> sorted = order.sorted(points);

  SolidFiltration filtration;
  Solid& delaunay = filtration.delaunay;
  delaunay = solid(sorted, infinity, {.neighbors = true, .threads = options.threads, .progress = options.progress});
  const GoOn go_on = [&] { return !options.progress || options.progress({delaunay.distinct, delaunay.distinct}); };
  Steps step(go_on);
  const space::RadiusRule rule(sorted);
  if (delaunay.simplices.empty() && delaunay.distinct > 1) {
    take_flat(sorted, options, threads, step, filtration);
  } else {
    const auto radii = [&](const GoOn& goes_on) {
      return space::circumradii_of(sorted, delaunay.simplices, threads, goes_on);
    };
    space::find_faces(rule, sorted.size(), radii, threads, go_on, filtration);
  }
  space::find_values_of_edges(rule, threads, go_on, filtration);
  order.rename_corners(threads, filtration);
  return filtration;
}

}  // namespace rbpa
