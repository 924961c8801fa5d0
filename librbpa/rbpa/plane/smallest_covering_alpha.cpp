#include "rbpa/plane/smallest_covering_alpha.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/radii/sorted_by_alpha.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/part_sizes.h"
#include "rbpa/plane/filtration/radii.h"
#include "rbpa/plane/filtration/solid_parts.h"

namespace rbpa {
namespace {

void check(const Covering& covering) {
  if (!(covering.share > 0 && covering.share <= 1))
    throw meshops::ContractViolation("smallest_covering: found the share " + text(covering.share) +
                                     ", expected a number above 0 and at most 1");
}

/// Adds triangles in ascending order of their radii. Returns the first radius at which is_enough(number of covered
/// points, sizes of solid components) is true; nothing if there is no such radius.
template <typename Enough>
std::optional<double> first_enough(const TriangleArrays& delaunay, std::size_t points, std::span<const double> radii,
                                   Steps& step, const Enough& is_enough) {
  const auto faces = sorted_by_alpha(radii, step);
  const OwnedTriangles triangles = in_order(delaunay, faces);
  SolidParts solid(triangles, points);
  // n triangles that are joined by edges have at most n + 2 vertices.
  PartSizes sizes(static_cast<std::uint32_t>(faces.size()) + 2);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    step();
    solid.add_next([&](std::uint32_t size) { sizes.remove(size); }, [&](std::uint32_t size) { sizes.add(size); });
    if (i + 1 < faces.size() && radii[faces[i + 1]] == radii[faces[i]]) continue;
    if (is_enough(solid.covered(), sizes)) return radii[faces[i]];
  }
  return std::nullopt;
}

/// Returns the least radius at which every point of the triangulation is in a triangle; 0 without triangles.
double covering_radius(const AlphaComplex& delaunay, std::size_t points, std::span<const double> radii) {
  std::vector<double> least(points, std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < radii.size(); ++t)
    for (const std::uint32_t corner : delaunay.triangles[t]) least[corner] = std::min(least[corner], radii[t]);
  double radius = 0;
  for (const Triangle& t : delaunay.triangles)
    for (const std::uint32_t corner : t) radius = std::max(radius, least[corner]);
  return radius;
}

/// Returns the least radius at which all points are in at most `max_components` solid components; nothing if there is
/// no such radius. Does not sort the triangles up to the radius that covers all points: on most sets, few triangles are
/// larger.
std::optional<double> smallest_of_all(const AlphaComplex& delaunay, std::size_t points, std::span<const double> radii,
                                      std::size_t max_components, Steps& step) {
  const double covering = covering_radius(delaunay, points, radii);
  std::vector<std::uint32_t> later;
  std::vector<double> later_radii;
  meshops::DisjointSets parts(radii.size());
  std::vector<std::uint8_t> is_in(radii.size(), 0);
  std::size_t components = 0;
  const auto add = [&](std::uint32_t t) {
    step();
    is_in[t] = 1;
    ++components;
    for (const std::uint32_t neighbor : delaunay.neighbors[t])
      if (neighbor != AlphaComplex::none && is_in[neighbor] != 0) components -= parts.join(t, neighbor);
  };
  for (std::uint32_t t = 0; t < radii.size(); ++t)
    if (radii[t] <= covering) {
      add(t);
    } else {
      later.push_back(t);
      later_radii.push_back(radii[t]);
    }
  if (radii.empty()) return std::nullopt;
  if (components <= max_components) return covering;
  const auto order = sorted_by_alpha(later_radii, step);
  for (std::size_t i = 0; i < order.size(); ++i) {
    add(later[order[i]]);
    const double radius = later_radii[order[i]];
    if (components <= max_components && (i + 1 == order.size() || later_radii[order[i + 1]] != radius)) return radius;
  }
  return std::nullopt;
}

std::optional<double> smallest(const AlphaComplex& delaunay, std::span<const double> radii, const Covering& covering,
                               Steps& step) {
  const std::size_t points = delaunay.distinct + delaunay.duplicates.size();
  const auto is_enough = [&](std::size_t count) { return is_share(count, delaunay.distinct, covering.share); };
  if (covering.share == 1)
    return smallest_of_all(delaunay, points, radii, covering.max_components.value_or(radii.size()), step);
  return first_enough(delaunay, points, radii, step, [&](std::size_t covered, const PartSizes& sizes) {
    if (!covering.max_components) return is_enough(covered);
    const std::size_t taken_away = sizes.sum() - sizes.largest(*covering.max_components);
    return taken_away <= covered && is_enough(covered - taken_away);
  });
}

std::optional<double> smallest(const AlphaComplex& delaunay, bool is_checked, const Filtration& filtration,
                               const Covering& covering, const GoOn& go_on) {
  require_same(filtration, delaunay, "smallest_covering");
  check(covering);
  if (covering.share == 1) return smallest_covering(filtration, covering.max_components);
  if (!covering.max_components) {
    const auto step = std::find_if(filtration.steps.begin(), filtration.steps.end(), [&](const FiltrationStep& s) {
      return is_share(s.covered, filtration.distinct, covering.share);
    });
    if (step == filtration.steps.end()) return std::nullopt;
    return step->alpha;
  }
  if (!is_checked) require_linked(delaunay, delaunay.distinct + delaunay.duplicates.size(), go_on);
  Steps step(go_on);
  return smallest(delaunay, filtration.triangle_alpha, covering, step);
}

}  // namespace

std::optional<double> smallest_covering(const Delaunay& delaunay, const Filtration& filtration,
                                        const Covering& covering, const GoOn& go_on) {
  return smallest(delaunay.triangulation(), true, filtration, covering, go_on);
}

std::optional<double> smallest_covering(const AlphaComplex& delaunay, const Filtration& filtration,
                                        const Covering& covering, const GoOn& go_on) {
  return smallest(delaunay, false, filtration, covering, go_on);
}

std::optional<double> smallest_covering(const Delaunay& delaunay, const Covering& covering, const GoOn& go_on) {
  Steps step(go_on);
  return smallest_covering(delaunay, radii_of(delaunay, step), covering, step);
}

std::optional<double> smallest_covering(const Delaunay& delaunay, std::span<const double> radii,
                                        const Covering& covering, Steps& step) {
  check(covering);
  return smallest(delaunay.triangulation(), radii, covering, step);
}

}  // namespace rbpa
