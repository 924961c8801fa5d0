#include "triangulation/close_surface.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "rbpa/fill_holes.h"
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

FillingCounts fill_chosen(std::span<const Point3> points, const HoleChoice& choice, BoundedSurface& bounded,
                          const SurfaceOptions& options) {
  std::vector<Hole> chosen;
  for (std::size_t i = 0; i < bounded.curves.size(); ++i)
    if (choice.has(bounded.curves[i], bounded.kinds[i])) chosen.push_back(bounded.curves[i]);
  if (chosen.empty()) return {};
  FilledSurface filled = fill_holes(points, bounded.surface, chosen, options);
  const FillingCounts counts = count(filled.holes);

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

/// Whether at each point several fans of triangles meet: the surface touches itself there.
std::vector<bool> touching_points(std::span<const Point3> points, const Surface& surface) {
  std::vector<bool> touching(points.size(), false);
  const std::vector<std::uint32_t> fans = split_fans(surface).point;  // ascending
  for (auto at = fans.begin(); (at = std::adjacent_find(at, fans.end())) != fans.end(); ++at) touching[*at] = true;
  return touching;
}

std::vector<bool> points_of(std::span<const Point3> points, std::span<const Hole> curves) {
  std::vector<bool> is_open(points.size(), false);
  for (const Hole& curve : curves)
    for (const RimEdge& edge : curve.edges) is_open[edge.from] = true;
  return is_open;
}

}  // namespace

FillingCounts close_all(std::span<const Point3> points, BoundedSurface& bounded, const SurfaceOptions& options) {
  constexpr int rounds = 4;
  constexpr double most = 0.05;         // of the triangles that are given up
  constexpr std::size_t longest = 256;  // edges of a curve around which triangles are given up
  const BoundedSurface whole = bounded;
  FillingCounts best = fill_chosen(points, {.rims = true}, bounded, options);
  // Triangles are given up around what is open, and once nothing is, around what touches.
  std::vector<Hole> open = bounded.curves;
  std::vector<bool> wrong = open.empty() ? touching_points(points, bounded.surface) : points_of(points, open);
  const auto count_of = [](const std::vector<bool>& which) { return std::count(which.begin(), which.end(), true); };
  auto least_touching = open.empty() ? count_of(wrong) : std::numeric_limits<std::ptrdiff_t>::max();
  std::vector<bool> kept(whole.surface.triangles.size(), true);
  for (int round = 0; round < rounds && count_of(wrong) > 0; ++round) {
    const auto is_too_long = [](const Hole& curve) { return curve.edges.size() > longest; };
    if (std::any_of(open.begin(), open.end(), is_too_long)) break;
    for (std::size_t t = 0; t < kept.size(); ++t) {
      const auto& corners = whole.surface.triangles[t];
      if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t p) { return wrong[p]; })) kept[t] = false;
    }
    BoundedSurface trial = part_of(points, whole, kept);
    const std::ptrdiff_t given_up = std::count(kept.begin(), kept.end(), false);
    if (static_cast<double>(given_up) > most * static_cast<double>(kept.size())) break;
    FillingCounts counts = fill_chosen(points, {.rims = true}, trial, options);
    open = trial.curves;
    wrong = open.empty() ? touching_points(points, trial.surface) : points_of(points, open);
    if (!open.empty()) continue;
    if (trial.components.all.size() > whole.components.all.size()) break;  // the surface must not fall apart
    const std::ptrdiff_t touching = count_of(wrong);
    if (touching >= least_touching) break;
    least_touching = touching;
    counts.given_up = static_cast<std::size_t>(given_up);
    best = counts;
    bounded = std::move(trial);
  }
  return best;
}

}  // namespace rbpa::app
