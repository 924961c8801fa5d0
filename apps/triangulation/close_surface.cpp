#include "triangulation/close_surface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

#include "rbpa/base/progress.h"
#include "rbpa/space/repair/fill_holes.h"

namespace rbpa::app {
namespace {

/// Returns the numbers of the triangles that are not new.
std::vector<std::uint32_t> old_ones(const std::vector<bool>& is_new) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t t = 0; t < is_new.size(); ++t)
    if (!is_new[t]) numbers.push_back(t);
  return numbers;
}

void renumber(std::vector<Hole>& curves, const std::vector<std::uint32_t>& number) {
  for (Hole& curve : curves)
    for (RimEdge& edge : curve.edges) edge.triangle = number[edge.triangle];
}

double area_of(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
  return std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2;
}

/// Replaces the surface. Requires: the curves have the triangle numbers of the new one.
void replace(std::span<const Point3> points, BoundedSurface& bounded, Surface surface, const std::vector<bool>& is_new,
             const SurfaceOptions& options) {
  const std::function<bool()> go_on = going_on(options.progress, points.size(), surface.triangles.size());
  bounded.surface = std::move(surface);
  bounded.filled = is_new;
  bounded.curves = with_causes(surface_curves(points, bounded.surface, go_on), bounded.curves);
  bounded.components = surface_components(points, bounded.surface, go_on);
  bounded.kinds = curve_kinds(points, bounded.components, bounded.curves);
}

}  // namespace

std::vector<Hole> with_causes(std::vector<Hole> curves, std::span<const Hole> known) {
  std::vector<const RimEdge*> edges;
  for (const Hole& curve : known)
    for (const RimEdge& edge : curve.edges) edges.push_back(&edge);
  const auto key = [](const RimEdge& edge) { return std::make_tuple(edge.triangle, edge.from); };
  const auto is_before = [&](const RimEdge* a, const RimEdge* b) { return key(*a) < key(*b); };
  std::sort(edges.begin(), edges.end(), is_before);
  for (Hole& curve : curves)
    for (RimEdge& edge : curve.edges) {
      const auto found = std::lower_bound(edges.begin(), edges.end(), &edge, is_before);
      if (found != edges.end() && key(**found) == key(edge)) edge = **found;
    }
  return curves;
}

void count_refined(std::span<const Point3> points, const Surface& surface, const std::vector<bool>& is_new,
                   const AddedPoints& added, FillingCounts& counts) {
  std::vector<double> areas;
  for (std::size_t t = 0; t < is_new.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    if (is_new[t]) areas.push_back(area_of(points[a], points[b], points[c]));
  }
  std::sort(areas.begin(), areas.end());
  counts.triangles = areas.size();
  counts.area = std::accumulate(areas.begin(), areas.end(), 0.0);
  counts.points = added.points.size();
  counts.smooth = added.smooth;
}

AddedPoints refine(std::span<const Point3> points, BoundedSurface& bounded, FillingCounts& counts,
                   const SurfaceOptions& options) {
  RefinedSurface refined = refine_filling(points, bounded.surface, bounded.filled, options);
  std::vector<Point3> all(points.begin(), points.end());
  all.insert(all.end(), refined.points.begin(), refined.points.end());
  count_refined(all, refined.surface, refined.is_new, refined, counts);
  const std::vector<std::uint32_t> was = old_ones(bounded.filled), is = old_ones(refined.is_new);
  std::vector<std::uint32_t> number(bounded.filled.size(), Surface::none);  // number of each triangle that is not new
  for (std::size_t i = 0; i < was.size(); ++i) number[was[i]] = is[i];
  renumber(bounded.curves, number);
  replace(all, bounded, std::move(refined.surface), refined.is_new, options);
  return refined;
}

FillingCounts fill_chosen(std::span<const Point3> points, const HoleChoice& choice, BoundedSurface& bounded,
                          const SurfaceOptions& options) {
  std::vector<Hole> chosen;
  for (std::size_t i = 0; i < bounded.curves.size(); ++i)
    if (choice.has(bounded.curves[i], bounded.kinds[i])) chosen.push_back(bounded.curves[i]);
  if (chosen.empty()) return {};
  FilledSurface filled = fill_holes(points, bounded.surface, chosen, options);
  const FillingCounts counts = count(filled.holes);
  renumber(bounded.curves, old_ones(filled.is_new));
  replace(points, bounded, std::move(filled.surface), filled.is_new, options);
  return counts;
}

}  // namespace rbpa::app
