#include "rbpa/plane/filtration.h"

#include <algorithm>
#include <cstdint>

#include "rbpa/base/run/steps.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/growth.h"
#include "rbpa/plane/filtration/least_alpha.h"
#include "rbpa/plane/filtration/radii.h"

namespace rbpa {
namespace {

/// A triangle with its sort key: by alpha, then by area, so that the sum of areas depends on coordinates only.
struct Entry {
  double alpha;
  double area;
  std::uint32_t triangle;
  friend bool operator<(const Entry& a, const Entry& b) {
    if (a.alpha != b.alpha) return a.alpha < b.alpha;
    if (a.area != b.area) return a.area < b.area;
    return a.triangle < b.triangle;
  }
};

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
  std::vector<Entry> entries(delaunay.triangles.size());
  for (std::uint32_t t = 0; t < entries.size(); ++t) {
    pulse();
    entries[t] = {result.triangle_alpha[t], static_cast<double>(area(corners_of(points, delaunay.triangles[t]))), t};
  }
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    pulse();
    return a < b;
  });

  const auto ends_step = [&](std::size_t i) {
    return i + 1 == entries.size() || entries[i + 1].alpha != entries[i].alpha;
  };
  std::size_t steps = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) steps += ends_step(i);
  result.steps.reserve(steps);
  Growth growth(delaunay, points.size());
  long double area = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    pulse();
    growth.add(entries[i].triangle);
    area += entries[i].area;
    if (ends_step(i)) result.steps.push_back(step_of(growth.counts(), entries[i].alpha, area));
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

}  // namespace rbpa
