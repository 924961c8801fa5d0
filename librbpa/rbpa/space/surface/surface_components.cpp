#include "rbpa/space/surface/surface_components.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/boundary_walk.h"
#include "rbpa/base/arrays/components.h"
#include "rbpa/base/arrays/fans.h"
#include "rbpa/base/arrays/grouped.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/cells/box_scale.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/crossing.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/surface/levels/sub_surface.h"

namespace rbpa {
namespace {

using space::Corners, space::corners_of;
using Vector = space::Vector3<double>;

/// A component, and the triangle that orders components of equal area and volume.
struct Measured : SurfaceComponent {
  Corners least{};  ///< least triangle; no other component has it, as triangles are oriented
};

/// Measures a component. Requires: at least one triangle.
Measured measure(std::span<const Point3> points, const Surface& surface, std::span<const std::uint32_t> triangles,
                 Steps& step) {
  Measured result;
  result.triangles = triangles.size();
  space::Box box;
  result.least = corners_of(points, surface.triangles[triangles.front()]);
  for (const std::uint32_t t : triangles) {
    step();
    for (const std::uint32_t other : surface.neighbors[t]) result.boundary_sides += other == Surface::none;
    const auto& triangle = surface.triangles[t];
    bool may_be_least = false;
    for (const std::uint32_t corner : triangle) {
      const Point3& p = points[corner];
      may_be_least |= !(result.least.front() < p);
      box.include(p);
    }
    if (may_be_least) result.least = std::min(result.least, corners_of(points, triangle));
  }

  result.low = box.low;
  result.high = box.high;
  const space::BoxScale scale(box.low, box.high);
  const auto minus = [](const Vector& v, const Vector& u) { return Vector{v.x - u.x, v.y - u.y, v.z - u.z}; };
  ExactSum areas, volumes;  // exact, so that the order of the triangles does not matter
  for (const std::uint32_t t : triangles) {
    step();
    const Corners corners = corners_of(points, surface.triangles[t]);
    const Vector a = scale.place(corners[0]), b = scale.place(corners[1]), c = scale.place(corners[2]);
    const Vector normal = space::cross(minus(b, a), minus(c, a));
    areas.add(std::hypot(normal.x, normal.y, normal.z) / 2);
    if (result.is_closed()) volumes.add(space::dot(a, normal) / 6);
  }
  result.area = areas.rounded(2 * scale.exponent());
  result.volume = volumes.rounded(3 * scale.exponent());
  return result;
}

/// Returns whether the numbers of components fit the surface.
bool are_of(const SurfaceComponents& components, const Surface& surface) {
  return components.number.size() == surface.triangles.size() &&
         std::all_of(components.number.begin(), components.number.end(),
                     [&](std::uint32_t c) { return c < components.all.size(); });
}

}  // namespace

SurfaceComponents surface_components(std::span<const Point3> points, const Surface& surface, const GoOn& go_on) {
  require_linked(space::arrays_of(surface), points.size(), go_on);
  const auto count = static_cast<std::uint32_t>(surface.triangles.size());
  Steps step(go_on);
  meshops::DisjointSets sets = components_of(space::arrays_of(surface), step);

  const space::Grouped grouped(count, count, [&](std::uint32_t t) { return sets.find(t); });

  SurfaceComponents result;
  result.number = grouped.number();
  std::vector<std::size_t> curves(grouped.size(), 0);
  BoundaryWalk walk(space::arrays_of(surface));
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      if (!walk.is_new({t, k})) continue;
      walk.walk_from({t, k}, [](const BoundarySide&) {});
      ++curves[result.number[t]];
    }
  std::vector<Measured> measured;
  for (std::size_t c = 0; c < grouped.size(); ++c) {
    measured.push_back(measure(points, surface, grouped.items(c), step));
    measured.back().boundary_curves = curves[c];
  }
  std::vector<std::uint32_t> order(measured.size()), place(measured.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  sort(order, step, [&](std::uint32_t i, std::uint32_t j) {
    const Measured &c = measured[i], &d = measured[j];
    if (c.area != d.area) return c.area > d.area;
    if (c.volume != d.volume) return c.volume > d.volume;
    return c.least < d.least;
  });
  for (const std::uint32_t c : order) {
    place[c] = static_cast<std::uint32_t>(result.all.size());
    result.all.push_back(measured[c]);
  }
  for (std::uint32_t& number : result.number) number = place[number];
  return result;
}

std::vector<std::size_t> genus_of(const Surface& surface, const SurfaceComponents& components, const GoOn& go_on) {
  require_linked(space::arrays_of(surface), std::numeric_limits<std::uint32_t>::max(), go_on);
  meshops::require(are_of(components, surface),
                   "genus_of: found components of another surface, expected surface_components() of this one");
  std::vector<std::size_t> genus;  // at first the number of vertices
  genus.resize(components.all.size(), 0);
  Steps step(go_on);
  const meshops::DisjointSets fans = fans_of(space::arrays_of(surface), step);
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner)
    if (fans.is_least(corner)) ++genus[components.number[corner / 3]];
  for (std::size_t c = 0; c < genus.size(); ++c) {
    const SurfaceComponent& component = components.all[c];
    // 2 − 2 genus − curves = vertices − edges + triangles.
    const std::size_t edges = (3 * component.triangles + component.boundary_sides) / 2;
    genus[c] = (2 + edges - component.triangles - genus[c] - component.boundary_curves) / 2;
  }
  return genus;
}

std::vector<bool> choose_components(const SurfaceComponents& components, const std::vector<bool>& outer,
                                    const ComponentChoice& choice) {
  if (choice.shell != ShellChoice::all)
    meshops::require_one_each("choose_components", outer.size(), "values of `outer`", components.all.size(),
                              "components");
  std::size_t left = choice.max_components.value_or(components.all.size());
  if (choice.shell == ShellChoice::largest) left = 1;
  std::vector<bool> kept;
  for (std::size_t c = 0; c < components.all.size(); ++c) {  // components are sorted by descending area
    const SurfaceComponent& component = components.all[c];
    const bool is_wanted = (choice.shell == ShellChoice::all || outer[c]) &&
                           component.triangles >= choice.min_triangles && component.area >= choice.min_area;
    kept.push_back(is_wanted && left > 0);
    left -= kept.back();
  }
  return kept;
}

DroppedComponents dropped_components(std::span<const Point3> points, const std::vector<bool>& kept,
                                     const Surface& surface, const SurfaceComponents& components, const GoOn& go_on) {
  meshops::require_one_each("dropped_components", kept.size(), "values of `kept`", components.all.size(), "components");
  require_linked(space::arrays_of(surface), points.size());
  DroppedComponents dropped;
  const std::vector<std::size_t> genus = genus_of(surface, components, go_on);
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
  std::vector<char> use(points.size(), 0);  // 1 for corners of dropped triangles only, 2 for corners of kept ones
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const char by = kept[components.number[t]] ? 2 : 1;
    for (const std::uint32_t corner : surface.triangles[t]) use[corner] = std::max(use[corner], by);
  }
  dropped.points = static_cast<std::size_t>(std::count(use.begin(), use.end(), 1));
  return dropped;
}

Surface keep_components(const Surface& surface, const SurfaceComponents& components, const std::vector<bool>& kept) {
  meshops::require(are_of(components, surface),
                   "keep_components: found components of another surface, expected surface_components() of this one");
  meshops::require_one_each("keep_components", kept.size(), "values of `kept`", components.all.size(), "components");
  std::vector<bool> triangles;
  triangles.reserve(surface.triangles.size());
  for (const std::uint32_t c : components.number) triangles.push_back(kept[c]);
  return keep_triangles(surface, triangles);
}

Surface keep_triangles(const Surface& surface, const std::vector<bool>& kept) {
  meshops::require_one_each("keep_triangles", kept.size(), "values of `kept`", surface.triangles.size(), "triangles");
  Surface result = space::part_of(surface, [&](std::size_t t) { return kept[t]; });
  result.duplicates = surface.duplicates;
  result.distinct = surface.distinct;
  return result;
}

}  // namespace rbpa
