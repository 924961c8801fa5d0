#include "rbpa/space/surface/curve_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "meshops/core/contract.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/space/cells/box_scale.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa {
namespace {

constexpr double island_share = 0.01, rim_share = 0.25;

using Vector = space::Vector3<double>;

/// Twice a vector area, as exact sums, which do not depend on the order of curves or on where a curve begins.
struct VectorArea {
  std::array<ExactSum, 3> sums;

  void operator+=(const VectorArea& other) {
    for (std::size_t k = 0; k < 3; ++k) sums[k] += other.sums[k];
  }
  Vector rounded() const { return {sums[0].rounded(), sums[1].rounded(), sums[2].rounded()}; }
};

VectorArea vector_area(std::span<const Point3> points, const Hole& curve, const space::BoxScale& scale) {
  VectorArea area;
  for (const RimEdge& edge : curve.edges) {
    const Vector product = space::cross(scale.place(points[edge.from]), scale.place(points[edge.to]));
    area.sums[0].add(product.x);
    area.sums[1].add(product.y);
    area.sums[2].add(product.z);
  }
  return area;
}

/// Returns, for each curve of one component, whether it is a rim. Requires: all curves of the component.
std::vector<bool> are_rims(std::span<const Point3> points, const SurfaceComponent& component,
                           std::span<const Hole* const> curves) {
  const space::BoxScale scale(component.low, component.high);
  VectorArea total;
  std::vector<Vector> areas;
  for (const Hole* curve : curves) {
    const VectorArea area = vector_area(points, *curve, scale);
    areas.push_back(area.rounded());
    total += area;
  }
  // The vector area of the component. For a tube it is near 0, because the areas of the two ends cancel.
  const Vector mean = total.rounded();
  const double length = std::hypot(mean.x, mean.y, mean.z);
  const double least = rim_share * std::ldexp(2 * component.area, -2 * scale.exponent());
  std::vector<bool> rims;
  for (const Vector& area : areas) rims.push_back(length >= least && space::dot(area, mean) >= least * length);
  return rims;
}

}  // namespace

std::vector<bool> islands(const SurfaceComponents& components) {
  std::vector<bool> result;
  for (const SurfaceComponent& component : components.all)
    result.push_back(!component.is_closed() && component.area < island_share * components.all.front().area);
  return result;
}

std::vector<Hole> chosen_curves(std::span<const Hole> curves, std::span<const CurveKind> kinds,
                                const HoleChoice& choice) {
  meshops::require_one_each("chosen_curves", kinds.size(), "kinds", curves.size(), "curves");
  std::vector<Hole> chosen;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (choice.has(curves[i], kinds[i])) chosen.push_back(curves[i]);
  return chosen;
}

std::vector<CurveKind> curve_kinds(std::span<const Point3> points, const SurfaceComponents& components,
                                   std::span<const Hole> curves) {
  for (const Hole& curve : curves) {
    meshops::require(!curve.edges.empty(), "curve_kinds: found a curve without edges, expected a result of holes()");
    for (const RimEdge& edge : curve.edges)
      meshops::require(
          edge.from < points.size() && edge.to < points.size() && edge.triangle < components.number.size() &&
              components.number[edge.triangle] < components.all.size(),
          "curve_kinds: found an edge of a curve at a point or triangle that does not exist, expected the result of "
          "holes() for these points and the surface of these components");
  }
  const auto component_of = [&](std::size_t i) { return components.number[curves[i].edges.front().triangle]; };
  std::vector<std::size_t> order(curves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return component_of(i) < component_of(j); });

  const std::vector<bool> is_island = islands(components);
  std::vector<CurveKind> kinds(curves.size(), CurveKind::island);
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    const std::uint32_t number = component_of(order[first]);
    const SurfaceComponent& component = components.all[number];
    std::vector<const Hole*> around;
    for (; last < order.size() && component_of(order[last]) == number; ++last) around.push_back(&curves[order[last]]);
    if (is_island[number]) continue;
    const std::vector<bool> rims = are_rims(points, component, around);
    for (std::size_t i = first; i < last; ++i) kinds[order[i]] = rims[i - first] ? CurveKind::rim : CurveKind::hole;
  }
  return kinds;
}

}  // namespace rbpa
