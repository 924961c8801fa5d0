#include "rbpa/plane/filtration.h"

#include <algorithm>
#include <cstdint>

#include "meshops/core/contract.h"
#include "rbpa/base/radii/sorted_by_alpha.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/arrays/keep_triangles.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/growth.h"
#include "rbpa/plane/filtration/least_alpha.h"
#include "rbpa/plane/filtration/radii.h"

namespace rbpa {
namespace {

FiltrationStep step_of(const ComplexCounts& counts, double alpha, long double area) {
  return {.alpha = alpha,
          .triangles = counts.triangles,
          .solid_components = counts.solid_components,
          .components = counts.components,
          .holes = counts.holes,
          .covered = counts.points_covered,
          .area = static_cast<double>(area)};
}

}  // namespace

std::vector<double> radii_of(const Delaunay& of, Steps& step) {
  const AlphaComplex& delaunay = of.triangulation();
  std::vector<double> radii(delaunay.triangles.size());
  for (std::size_t t = 0; t < radii.size(); ++t) {
    step();
    const auto [a, b, c] = corners_of(of.points(), delaunay.triangles[t]);
    radii[t] = least_alpha(a, b, c);
  }
  return radii;
}

Filtration filtration(const Delaunay& of, const GoOn& go_on) {
  const AlphaComplex& delaunay = of.triangulation();
  const std::span<const Point> points = of.points();
  Steps pulse(go_on);
  Filtration result{.steps = {}, .triangle_alpha = radii_of(of, pulse), .distinct = delaunay.distinct};
  const std::vector<double>& alpha = result.triangle_alpha;
  std::vector<double> areas(alpha.size());
  for (std::size_t t = 0; t < areas.size(); ++t) {
    pulse();
    areas[t] = static_cast<double>(area(corners_of(points, delaunay.triangles[t])));
  }
  auto order = sorted_by_alpha(alpha, pulse);
  sort_equal_by_volume<double>(order, alpha, areas, pulse);  // so that the sum of areas depends on coordinates only

  const auto ends_step = [&](std::size_t i) { return i + 1 == order.size() || alpha[order[i + 1]] != alpha[order[i]]; };
  std::size_t steps = 0;
  for (std::size_t i = 0; i < order.size(); ++i) steps += ends_step(i);
  result.steps.reserve(steps);
  Growth growth(delaunay, points.size());
  long double area = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    pulse();
    growth.add(order[i]);
    area += areas[order[i]];
    if (ends_step(i)) result.steps.push_back(step_of(growth.counts(), alpha[order[i]], area));
  }
  return result;
}

std::optional<double> smallest_covering(const Filtration& filtration, std::optional<std::size_t> max_components) {
  const auto step = std::find_if(filtration.steps.begin(), filtration.steps.end(), [&](const FiltrationStep& s) {
    return s.covered == filtration.distinct && (!max_components || s.solid_components <= *max_components);
  });
  if (step == filtration.steps.end()) return std::nullopt;
  return step->alpha;
}

AlphaComplex complex_at(const Delaunay& of, const Filtration& filtration, double alpha) {
  if (!(alpha > 0))
    throw meshops::ContractViolation("complex_at: found alpha " + text(alpha) +
                                     ", expected a number above 0, or infinity");
  require_same(filtration, of.triangulation(), "complex_at");
  return complex_at(of, std::span<const double>(filtration.triangle_alpha), alpha);
}

AlphaComplex complex_at(const Delaunay& of, std::span<const double> radii, double alpha) {
  AlphaComplex complex = of.triangulation();
  keep_triangles(complex, [&](std::size_t t) { return radii[t] <= alpha; });
  complex.isolated = isolated_in(complex, of.points().size());
  complex.boundary.clear();
  return complex;
}

}  // namespace rbpa
