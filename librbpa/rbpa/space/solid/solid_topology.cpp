#include "rbpa/space/solid/solid_topology.h"

#include <cstdint>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/space/solid/boundary/connected.h"
#include "rbpa/space/solid/boundary/outside.h"

namespace rbpa {
namespace {

std::size_t count_sets(const meshops::DisjointSets& sets) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < sets.size(); ++i) count += sets.is_least(i) ? 1u : 0u;
  return count;
}

}  // namespace

SolidCounts space::count_solid(const Solid& solid, const SolidBoundary& boundary, const Outside& outside) {
  SolidCounts counts;
  counts.points = solid.distinct - solid.isolated.size();
  counts.tetrahedra = solid.simplices.size();
  counts.boundary_triangles = boundary.tetrahedra.size();
  counts.triangles = (4 * counts.tetrahedra + counts.boundary_triangles) / 2;
  counts.solid_components = count_sets(outside.solid_components);
  counts.components = count_sets(outside.components);
  const std::size_t surfaces = count_sets(outside.surfaces);
  // Signed numbers, because sums may be negative if `boundary` is not the boundary of `solid`.
  const auto signed_of = [](std::size_t count) { return static_cast<std::ptrdiff_t>(count); };
  const std::ptrdiff_t euler = outside.twice_euler / 2;
  const std::ptrdiff_t edges =
      signed_of(counts.points) + signed_of(counts.triangles) - signed_of(counts.tetrahedra) - euler;
  // Each component has one outer surface; every other surface bounds a void.
  const std::ptrdiff_t voids = signed_of(surfaces) - signed_of(counts.components);
  const std::ptrdiff_t tunnels = signed_of(surfaces) - euler;
  meshops::require(outside.twice_euler % 2 == 0 && edges >= 0 && voids >= 0 && tunnels >= 0, not_its_boundary);
  counts.edges = static_cast<std::size_t>(edges);
  counts.voids = static_cast<std::size_t>(voids);
  counts.tunnels = static_cast<std::size_t>(tunnels);
  return counts;
}

SolidCounts count(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary) {
  return space::count_solid(solid, boundary, space::outside_of(points, solid, boundary));
}

}  // namespace rbpa
