#include "rbpa/filtration.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "rbpa/base/pulse.h"
#include "rbpa/plane/filtration/corners.h"
#include "rbpa/plane/filtration/growth.h"
#include "rbpa/plane/filtration/least_alpha.h"

namespace rbpa {
namespace {

/// What the sum of areas depends on is ordered by coordinates only: by alpha, then by area.
struct Entry {
  double alpha;
  double area;
  std::uint32_t face;
  friend bool operator<(const Entry& a, const Entry& b) {
    if (a.alpha != b.alpha) return a.alpha < b.alpha;
    if (a.area != b.area) return a.area < b.area;
    return a.face < b.face;
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

Filtration filtration(const SolidAlphaComplex& delaunay, std::span<const Point> points,
                      const std::function<bool()>& go_on) {
  Pulse pulse(go_on);
  const Corners corners(delaunay, points);
  meshops::require(delaunay.mesh.n_faces() == 0 || delaunay.isolated.empty(),
                   "filtration: the complex leaves points out, so it is not the Delaunay triangulation");
  Filtration result{.steps = {}, .triangle_alpha = {}, .distinct = delaunay.distinct};
  result.triangle_alpha.resize(delaunay.mesh.n_faces());
  std::vector<Entry> entries(delaunay.mesh.n_faces());
  for (std::uint32_t f = 0; f < entries.size(); ++f) {
    pulse.beat();
    const std::array<Point, 3> triangle = corners.of_face(f);
    result.triangle_alpha[f] = least_alpha(triangle[0], triangle[1], triangle[2]);
    entries[f] = {result.triangle_alpha[f], static_cast<double>(area(triangle)), f};
  }
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    pulse.beat();
    return a < b;
  });

  const auto ends_step = [&](std::size_t i) {
    return i + 1 == entries.size() || entries[i + 1].alpha != entries[i].alpha;
  };
  std::size_t steps = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) steps += ends_step(i);
  result.steps.reserve(steps);
  Growth growth(delaunay);
  long double area = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    pulse.beat();
    growth.add(entries[i].face);
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
