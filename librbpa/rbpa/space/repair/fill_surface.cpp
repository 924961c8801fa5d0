#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/repair/closing/links_of_triangles.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/surface/split_fans.h"

namespace rbpa {
namespace {

/// Returns the vertex at `point` of the fan that contains `triangle`.
std::uint32_t vertex_at(const Surface& surface, const SplitFans& fans, std::uint32_t triangle, std::uint32_t point) {
  const Triangle& corners = surface.triangles[triangle];
  const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), point) - corners.begin());
  if (k == 3)
    throw meshops::ContractViolation("fill_holes: found an edge of a curve from point " + std::to_string(point) +
                                     ", which is no corner of its triangle " + std::to_string(triangle) +
                                     ", expected boundary curves of this surface");
  return fans.triangles[triangle][k];
}

}  // namespace

FilledSurface fill_holes(std::span<const Point3> points, const Surface& surface, std::span<const Hole> curves,
                         const SurfaceOptions& options) {
  const GoOn go_on = go_on_of(options.progress, points.size(), surface.triangles.size());
  const SplitFans fans = split_fans(surface, go_on);
  std::vector<Point3> places;
  places.reserve(fans.point.size());
  for (const std::uint32_t point : fans.point) {
    meshops::require(point < points.size(), "fill_holes: found corner ", point,
                     " of the surface, expected the index of a point");
    places.push_back(points[point]);
  }
  std::vector<std::vector<std::uint32_t>> loops;
  for (const Hole& curve : curves) {
    std::vector<std::uint32_t>& loop = loops.emplace_back();
    for (const RimEdge& edge : curve.edges) {
      meshops::require(edge.triangle < surface.triangles.size(), "fill_holes: found triangle ", edge.triangle,
                       " in a curve, expected a triangle of this surface");
      loop.push_back(vertex_at(surface, fans, edge.triangle, edge.from));
    }
  }
  HoleFilling filling = fill_holes(places, fans.triangles, loops, options);

  FilledSurface result;
  result.holes = std::move(filling.loops);
  result.surface.duplicates = surface.duplicates;
  result.surface.distinct = surface.distinct;
  meshops::Steps step(go_on);
  space::LinkedTriangles linked = space::linked_triangles(filling.triangles, fans.point, step);
  result.surface.triangles = std::move(linked.triangles);
  result.surface.neighbors = std::move(linked.neighbors);
  for (const std::uint32_t t : linked.order) result.is_new.push_back(t >= surface.triangles.size());
  return result;
}

FilledSurface fill_holes(std::span<const Point3> points, const Surface& surface, const HoleChoice& choice,
                         const SurfaceOptions& options) {
  const GoOn go_on = go_on_of(options.progress, points.size(), surface.triangles.size());
  const Surface open = indexable_surface(surface, go_on);
  const std::vector<Hole> curves = surface_curves(points, open, go_on);
  const std::vector<CurveKind> kinds = curve_kinds(points, surface_components(points, open, go_on), curves);
  return fill_holes(points, open, chosen_curves(curves, kinds, choice), options);
}

}  // namespace rbpa
