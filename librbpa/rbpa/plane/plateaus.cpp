#include "rbpa/plane/plateaus.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rbpa/base/radii/plateau_rules.h"
#include "rbpa/base/radii/still_ranges.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/shape_curve.h"
#include "rbpa/plane/grid/box.h"
#include "rbpa/plane/smallest_covering_alpha.h"

namespace rbpa {
namespace {

/// Returns the ratio that plateaus of noise do not reach; docs/explanation/filtration_and_persistence.md, sections 6
/// and 7, describes the measurement.
double noise_ratio(std::size_t distinct) { return 1.4 + 10 / std::sqrt(static_cast<double>(distinct)); }

/// Returns half the diagonal of the box of the points.
double reach_of(std::span<const Point> points) {
  const auto [low, high] = box_of(points);
  const long double width = static_cast<long double>(high.x) - low.x;
  const long double height = static_cast<long double>(high.y) - low.y;
  return static_cast<double>(std::sqrt(width * width + height * height) / 2);
}

/// Returns the plateau of a range of steps whose ratio is `ratio`.
Plateau plateau_of(const StepRange& range, const Filtration& filtration, const std::vector<ShapeState>& curve,
                   double ratio) {
  const std::vector<FiltrationStep>& steps = filtration.steps;
  Plateau plateau{.from = steps[range.first].alpha, .ratio = ratio};
  if (range.last < steps.size()) plateau.to = steps[range.last].alpha;
  plateau.alpha = plateau.from * std::min(std::sqrt(plateau.ratio), plateau_settles);
  const auto after = std::upper_bound(steps.begin(), steps.end(), plateau.alpha,
                                      [](double alpha, const FiltrationStep& step) { return alpha < step.alpha; });
  const auto at = static_cast<std::size_t>(after - steps.begin()) - 1;
  plateau.step = steps[at];
  plateau.effective_parts = curve[at].effective_parts;
  plateau.hole_share = curve[at].hole_share;
  if (plateau_rules::is_structured(plateau.effective_parts, plateau.hole_share)) plateau.kind = PlateauKind::structured;
  plateau.is_long = plateau.ratio >= noise_ratio(filtration.distinct);
  return plateau;
}

}  // namespace

std::vector<Plateau> plateaus(const Delaunay& delaunay, const Filtration& filtration, const GoOn& go_on) {
  require_same(filtration, delaunay.triangulation(), "plateaus");
  Steps pulse(go_on);
  const std::vector<ShapeState> curve = shape_curve(delaunay, filtration, pulse);
  if (curve.empty()) return {};
  std::vector<double> alpha;
  std::vector<long double> change;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    alpha.push_back(filtration.steps[i].alpha);
    change.push_back(curve[i].change);
  }
  const auto begin = std::find_if(filtration.steps.begin(), filtration.steps.end(), [&](const FiltrationStep& step) {
    return is_share(step.covered, filtration.distinct, plateau_rules::least_share);
  });
  const StepRange all{static_cast<std::size_t>(begin - filtration.steps.begin()), filtration.steps.size()};
  const StillRanges ranges(alpha, std::move(change), reach_of(delaunay.points()));
  std::vector<Plateau> found;
  for (const StepRange& range : ranges.longest(all, plateau_rules::most_plateaus, plateau_rules::least_ratio))
    found.push_back(plateau_of(range, filtration, curve, ranges.ratio_of(range)));
  plateau_rules::rank(found, [&](const Plateau& p) {
    return plateau_rules::Weight{p.kind == PlateauKind::structured,
                                 static_cast<double>(p.step.covered) / static_cast<double>(filtration.distinct)};
  });
  return found;
}

}  // namespace rbpa
