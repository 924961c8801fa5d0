#include "rbpa/space/repair/close_surface.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa {
namespace {

std::ptrdiff_t count_of(const std::vector<bool>& which) { return std::count(which.begin(), which.end(), true); }

/// Returns the `kept` triangles of a surface, except components that thereby become islands; clears the flags of these.
/// Requires: `kept` has one entry for each triangle.
Surface part_of(std::span<const Point3> points, const Surface& whole, std::vector<bool>& kept, const GoOn& go_on) {
  for (;;) {
    Surface part = indexable_surface(keep_triangles(whole, kept), go_on);
    const SurfaceComponents components = surface_components(points, part, go_on);
    const std::vector<bool> is_island = islands(components);
    if (count_of(is_island) == 0) return part;
    std::size_t next = 0;  // number of a triangle in the part
    for (std::size_t t = 0; t < kept.size(); ++t)
      if (kept[t]) kept[t] = !is_island[components.number[next++]];
  }
}

std::vector<bool> points_of(std::span<const Point3> points, std::span<const Hole> curves) {
  std::vector<bool> is_open(points.size(), false);
  for (const Hole& curve : curves)
    for (const RimEdge& edge : curve.edges) is_open[edge.from] = true;
  return is_open;
}

ClosedSurface fill_all(std::span<const Point3> points, const Surface& surface, const SurfaceOptions& options,
                       const GoOn& go_on) {
  return {fill_holes(points, surface, surface_curves(points, surface, go_on), options),
          std::vector<bool>(surface.triangles.size(), true)};
}

}  // namespace

std::vector<bool> touching_points(std::span<const Point3> points, const Surface& surface, const GoOn& go_on) {
  std::vector<bool> touching(points.size(), false);
  const std::vector<std::uint32_t> fans = split_fans(surface, go_on).point;  // ascending
  meshops::require(fans.empty() || fans.back() < points.size(),
                   "touching_points: the surface has a corner that is not a point");
  for (auto at = fans.begin(); (at = std::adjacent_find(at, fans.end())) != fans.end(); ++at) touching[*at] = true;
  return touching;
}

ClosedSurface close_surface(std::span<const Point3> points, const Surface& surface, const SurfaceOptions& options) {
  constexpr int rounds = 4;
  constexpr double most = 0.05;         // maximum fraction of the triangles that are removed
  constexpr std::size_t longest = 256;  // maximum number of edges of an open curve in a round
  const GoOn go_on = go_on_of(options.progress, points.size(), surface.triangles.size());
  ClosedSurface best = fill_all(points, surface, options, go_on);
  // Triangles are removed around open curves and, once there are none, around points where sheets touch.
  std::vector<Hole> open = surface_curves(points, best.surface, go_on);
  std::vector<bool> wrong = open.empty() ? touching_points(points, best.surface, go_on) : points_of(points, open);
  auto least_touching = open.empty() ? count_of(wrong) : std::numeric_limits<std::ptrdiff_t>::max();
  const std::size_t components = surface_components(points, surface, go_on).all.size();
  std::vector<bool> kept(surface.triangles.size(), true);
  for (int round = 0; round < rounds && count_of(wrong) > 0; ++round) {
    const auto is_too_long = [](const Hole& curve) { return curve.edges.size() > longest; };
    if (std::any_of(open.begin(), open.end(), is_too_long)) break;
    for (std::size_t t = 0; t < kept.size(); ++t) {
      const auto& corners = surface.triangles[t];
      if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t p) { return wrong[p]; })) kept[t] = false;
    }
    const Surface part = part_of(points, surface, kept, go_on);
    const std::ptrdiff_t given_up = std::count(kept.begin(), kept.end(), false);
    if (static_cast<double>(given_up) > most * static_cast<double>(kept.size())) break;
    ClosedSurface trial = fill_all(points, part, options, go_on);
    open = surface_curves(points, trial.surface, go_on);
    wrong = open.empty() ? touching_points(points, trial.surface, go_on) : points_of(points, open);
    if (!open.empty()) continue;
    if (surface_components(points, trial.surface, go_on).all.size() > components)
      break;  // the surface must not split into more components
    const std::ptrdiff_t touching = count_of(wrong);
    if (touching >= least_touching) break;
    least_touching = touching;
    trial.kept = kept;
    trial.given_up = static_cast<std::size_t>(given_up);
    best = std::move(trial);
  }
  return best;
}

}  // namespace rbpa
