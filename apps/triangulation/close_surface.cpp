#include "triangulation/close_surface.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "rbpa/split_fans.h"

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

namespace {

/// Some triangles of a surface, without the islands that they make. Requires: all `kept` but of triangles; clears islands there.
BoundedSurface part_of(std::span<const Point3> points, const BoundedSurface& whole, std::vector<bool>& kept) {
  for (;;) {
    BoundedSurface part{
        .surface = indexable_surface(keep_triangles(whole.surface, kept)), .components = {}, .curves = {}, .kinds = {}};
    part.components = surface_components(points, part.surface);
    part.curves = surface_curves(points, part.surface);
    part.kinds = curve_kinds(points, part.components, part.curves);
    std::vector<bool> is_island(part.components.all.size(), false);
    for (std::size_t i = 0; i < part.curves.size(); ++i)
      if (part.kinds[i] == CurveKind::island)
        is_island[part.components.number[part.curves[i].edges.front().triangle]] = true;
    if (std::count(is_island.begin(), is_island.end(), true) == 0) return part;
    std::size_t next = 0;  // triangle of the part
    for (std::size_t t = 0; t < kept.size(); ++t)
      if (kept[t]) kept[t] = !is_island[part.components.number[next++]];
  }
}

}  // namespace

FillingCounts close_all(std::span<const Point3> points, BoundedSurface& bounded, const SurfaceOptions& options) {
  constexpr int rounds = 4;
  constexpr double most = 0.05;         // of the triangles that are given up
  constexpr std::size_t longest = 256;  // edges of a curve around which triangles are given up
  const BoundedSurface whole = bounded;
  const FillingCounts first = fill_chosen(points, {}, true, bounded, options);
  std::vector<Hole> open = bounded.curves;
  std::vector<bool> kept(whole.surface.triangles.size(), true);
  for (int round = 0; round < rounds && !open.empty(); ++round) {
    std::vector<bool> is_open(points.size(), false);
    for (const Hole& curve : open) {
      if (curve.edges.size() > longest) return first;
      for (const RimEdge& edge : curve.edges) is_open[edge.from] = true;
    }
    for (std::size_t t = 0; t < kept.size(); ++t) {
      const auto& corners = whole.surface.triangles[t];
      if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t p) { return is_open[p]; })) kept[t] = false;
    }
    BoundedSurface trial = part_of(points, whole, kept);
    const auto given_up = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
    if (static_cast<double>(given_up) > most * static_cast<double>(kept.size())) return first;
    FillingCounts counts = fill_chosen(points, {}, true, trial, options);
    open = std::move(trial.curves);
    if (!open.empty()) continue;
    // The surface must not fall apart.
    if (trial.components.all.size() > whole.components.all.size()) return first;
    counts.given_up = given_up;
    bounded = std::move(trial);
    return counts;
  }
  return first;
}

}  // namespace rbpa::app
