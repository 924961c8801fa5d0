#include "rbpa/space/surface/levels/local_surface.h"

#include <algorithm>

#include "rbpa/base/arrays/sort_unique.h"

namespace rbpa::space {
namespace {

std::uint32_t place_in(std::span<const std::uint32_t> sorted, std::uint32_t value) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

}  // namespace

std::uint32_t LocalSurface::number_of(std::uint32_t input_index) const { return place_in(input, input_index); }

LocalSurfaces::LocalSurfaces(std::span<const Point3> points, std::span<const Point3> normals, const Surface& surface)
    : points_(points), normals_(normals), surface_(surface), triangles_at_(surface.triangles, points.size()) {}

LocalSurface LocalSurfaces::at(std::span<const std::uint32_t> points) const {
  LocalSurface local;
  std::vector<std::uint32_t> kept;
  local.input.assign(points.begin(), points.end());
  for (const std::uint32_t point : points)
    for (const std::uint32_t t : triangles_at_[point]) kept.push_back(t);
  sort_unique(kept);
  for (const std::uint32_t t : kept) {
    const auto& corners = surface_.triangles[t];
    local.input.insert(local.input.end(), corners.begin(), corners.end());
  }
  sort_unique(local.input);
  for (const std::uint32_t i : local.input) {
    local.points.push_back(points_[i]);
    local.normals.push_back(normals_[i]);
  }

  Surface& surface = local.surface;
  for (const std::uint32_t t : kept) {
    auto& corners = surface.triangles.emplace_back(surface_.triangles[t]);
    for (std::uint32_t& corner : corners) corner = local.number_of(corner);
    auto& neighbors = surface.neighbors.emplace_back(surface_.neighbors[t]);
    for (std::uint32_t& other : neighbors) {
      const std::uint32_t place = place_in(kept, other);
      other = place < kept.size() && kept[place] == other ? place : Surface::none;
    }
    surface.levels.push_back(surface_.levels.empty() ? 0 : surface_.levels[t]);
  }
  const auto is_before = [](const Duplicate& d, std::uint32_t index) { return d.index < index; };
  auto next = surface_.duplicates.begin();
  for (std::uint32_t i = 0; i < local.input.size(); ++i) {
    next = std::lower_bound(next, surface_.duplicates.end(), local.input[i], is_before);
    if (next != surface_.duplicates.end() && next->index == local.input[i])
      surface.duplicates.push_back({i, local.number_of(next->stands_for)});
  }
  surface.distinct = local.input.size() - surface.duplicates.size();
  return local;
}

}  // namespace rbpa::space
