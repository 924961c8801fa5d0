#include "space/drop_components.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "io/interrupt.h"

namespace rbpa::app {

DroppedComponents dropped_components(std::span<const Point3> points, const std::vector<bool>& kept,
                                     const Surface& surface, const SurfaceComponents& components) {
  DroppedComponents dropped;
  if (std::find(kept.begin(), kept.end(), false) == kept.end()) return dropped;
  const std::vector<std::size_t> genus = genus_of(surface, components, until_interrupted());
  for (std::size_t c = 0; c < kept.size(); ++c) {
    const SurfaceComponent& component = components.all[c];
    ++dropped.of_components;
    dropped.of_triangles += component.triangles;
    dropped.of_area += component.area;
    dropped.of_genus += genus[c];
    if (kept[c]) continue;
    ++dropped.components;
    dropped.triangles += component.triangles;
    dropped.area += component.area;
    dropped.genus += genus[c];
  }
  std::vector<char> use(points.size(), 0);  // of each point, 1: only by dropped triangles, 2: by kept ones
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const char by = kept[components.number[t]] ? 2 : 1;
    for (const std::uint32_t corner : surface.triangles[t]) use[corner] = std::max(use[corner], by);
  }
  dropped.points = static_cast<std::size_t>(std::count(use.begin(), use.end(), 1));
  return dropped;
}

void drop_components(std::span<const Point3> points, const std::vector<bool>& kept, Surface& surface,
                     SurfaceComponents& components, SurfaceFacts& facts) {
  facts.dropped = dropped_components(points, kept, surface, components);
  std::vector<std::uint32_t> number;  // new number of each kept triangle; for others that of the next kept one
  std::uint32_t next = 0;
  for (const std::uint32_t c : components.number) {
    number.push_back(next);
    next += kept[c];
  }
  std::vector<Hole> holes;
  std::vector<CurveKind> kinds;
  for (std::size_t i = 0; i < facts.holes.size(); ++i) {
    Hole& hole = facts.holes[i];
    if (!kept[components.number[hole.edges.front().triangle]]) continue;
    for (RimEdge& edge : hole.edges) edge.triangle = number[edge.triangle];
    holes.push_back(std::move(hole));
    kinds.push_back(facts.kinds[i]);
  }
  facts.holes = std::move(holes);
  facts.kinds = std::move(kinds);
  surface = keep_components(surface, components, kept);
  components = surface_components(points, surface, until_interrupted());
}

}  // namespace rbpa::app
