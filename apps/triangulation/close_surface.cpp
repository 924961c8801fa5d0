#include "triangulation/close_surface.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rbpa::app {

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

FillingCounts fill_chosen(std::span<const Point3> points, const HoleChoice& choice, bool rims, BoundedSurface& bounded,
                          const SurfaceOptions& options) {
  std::vector<Hole> chosen;
  for (std::size_t i = 0; i < bounded.curves.size(); ++i)
    if ((rims || bounded.kinds[i] == CurveKind::hole) && choice.has(bounded.curves[i]))
      chosen.push_back(bounded.curves[i]);
  FillingCounts counts;
  if (chosen.empty()) return counts;
  FilledSurface filled = fill_holes(points, bounded.surface, chosen, options);
  std::vector<double> areas;
  for (const HoleFill& hole : filled.holes) {
    ++counts.holes[static_cast<std::size_t>(hole.outcome)];
    counts.triangles += hole.triangles;
    areas.push_back(hole.area);
  }
  std::sort(areas.begin(), areas.end());  // the order of holes depends on that of the points, and their sum must not
  for (const double area : areas) counts.area += area;

  // Old triangles stay in their order, so that the edges of curves find them by counting.
  std::vector<std::uint32_t> number;
  for (std::uint32_t t = 0; t < filled.is_new.size(); ++t)
    if (!filled.is_new[t]) number.push_back(t);
  for (Hole& curve : bounded.curves)
    for (RimEdge& edge : curve.edges) edge.triangle = number[edge.triangle];
  bounded.surface = std::move(filled.surface);
  bounded.curves = with_causes(surface_curves(points, bounded.surface), bounded.curves);
  bounded.components = surface_components(points, bounded.surface);
  bounded.kinds = curve_kinds(points, bounded.components, bounded.curves);
  return counts;
}

}  // namespace rbpa::app
