#include "triangulation/close_surface.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "rbpa/close_surface.h"
#include "rbpa/fill_holes.h"

namespace rbpa::app {
namespace {

/// Another surface in place of one, with the triangles that are not new in the order in which they were.
void replace(std::span<const Point3> points, BoundedSurface& bounded, Surface surface,
             const std::vector<bool>& is_new) {
  std::vector<std::uint32_t> number;
  for (std::uint32_t t = 0; t < is_new.size(); ++t)
    if (!is_new[t]) number.push_back(t);
  for (Hole& curve : bounded.curves)
    for (RimEdge& edge : curve.edges) edge.triangle = number[edge.triangle];
  bounded.surface = std::move(surface);
  bounded.filled = is_new;
  bounded.curves = with_causes(surface_curves(points, bounded.surface), bounded.curves);
  bounded.components = surface_components(points, bounded.surface);
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

FillingCounts fill_chosen(std::span<const Point3> points, const HoleChoice& choice, BoundedSurface& bounded,
                          const SurfaceOptions& options) {
  std::vector<Hole> chosen;
  for (std::size_t i = 0; i < bounded.curves.size(); ++i)
    if (choice.has(bounded.curves[i], bounded.kinds[i])) chosen.push_back(bounded.curves[i]);
  if (chosen.empty()) return {};
  FilledSurface filled = fill_holes(points, bounded.surface, chosen, options);
  const FillingCounts counts = count(filled.holes);
  replace(points, bounded, std::move(filled.surface), filled.is_new);
  return counts;
}

FillingCounts close_all(std::span<const Point3> points, BoundedSurface& bounded, const SurfaceOptions& options) {
  ClosedSurface closed = close_surface(points, bounded.surface, options);
  FillingCounts counts = count(closed.holes);
  counts.given_up = closed.given_up;
  if (closed.given_up > 0) bounded.curves.clear();  // it is closed
  replace(points, bounded, std::move(closed.surface), closed.is_new);
  return counts;
}

}  // namespace rbpa::app
