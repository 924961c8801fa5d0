#include "rbpa/space/repair/watertight.h"

#include "meshops/core/contract.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/split_fans.h"

namespace rbpa {

WatertightSurface make_watertight(std::span<const Point3> points, const Surface& surface,
                                  const WatertightOptions& options, const SurfaceOptions& run) {
  const GoOn go_on = go_on_of(run.progress, points.size(), surface.triangles.size());
  SurfaceComponents own;
  if (options.components == nullptr) own = surface_components(points, surface, go_on);
  const SurfaceComponents& components = options.components == nullptr ? own : *options.components;
  std::vector<bool> stays = islands(components);
  stays.flip();
  if (!options.kept.empty())
    meshops::require_one_each("make_watertight", options.kept.size(), "values of `kept`", stays.size(), "components");
  for (std::size_t c = 0; c < options.kept.size(); ++c) stays[c] = stays[c] && options.kept[c];
  std::vector<bool> kept;
  for (const std::uint32_t c : components.number) kept.push_back(stays[c]);

  WatertightSurface result{close_surface(points, indexable_surface(keep_triangles(surface, kept), go_on), run)};
  result.components = std::move(stays);
  for (std::size_t t = 0, next = 0; t < kept.size(); ++t)
    if (kept[t]) kept[t] = result.kept[next++];
  result.kept = std::move(kept);

  std::span<const Point3> places = options.places.empty() ? points : options.places;
  meshops::require_one_each("make_watertight", places.size(), "places", points.size(), "points");
  std::vector<Point3> all;
  if (options.refine && result.has_filled()) {
    result.added = refine_filling(places, result, run);
    all.assign(places.begin(), places.end());
    all.insert(all.end(), result.added.points.begin(), result.added.points.end());
    places = all;
  }
  result.open = surface_curves(all.empty() ? points : places, result.surface, go_on);
  result.crossing = crossing_triangles(places, result.surface.triangles, most_crossing_pairs, run);
  return result;
}

}  // namespace rbpa
