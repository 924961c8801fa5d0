#include "rbpa/plateaus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "rbpa/base/steps.h"
#include "rbpa/base/still_ranges.h"
#include "rbpa/covering.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/shape_curve.h"

namespace rbpa {
namespace {

constexpr double least_ratio = 1.25;      // of a plateau that is worth a line
constexpr std::size_t most_plateaus = 8;  // that are looked for
constexpr double least_share = 0.5;       // of the points, covered where a plateau begins
constexpr double one_part = 1.1;          // effective parts: one of 95 points of a hundred has 1.1
constexpr double small_holes = 0.05;
constexpr double most = 0.9;  // of the points

/// A ratio that noise does not reach: see docs/which_alpha.md for how it was measured.
double noise_ratio(std::size_t distinct) { return 1.4 + 10 / std::sqrt(static_cast<double>(distinct)); }

/// Half the diagonal of the box of the points.
double reach_of(std::span<const Point> points) {
  Point least = points[0], greatest = points[0];
  for (const Point& p : points) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y)};
  }
  const long double width = static_cast<long double>(greatest.x) - least.x;
  const long double height = static_cast<long double>(greatest.y) - least.y;
  return static_cast<double>(std::sqrt(width * width + height * height) / 2);
}

/// What a range is as a plateau.
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
  if (plateau.effective_parts >= one_part || plateau.hole_share >= small_holes) plateau.kind = PlateauKind::structured;
  plateau.is_long = plateau.ratio >= noise_ratio(filtration.distinct);
  return plateau;
}

/// Parts that join into one piece later come first; then that piece, or what closes around it, such as the mouth of a
/// crescent; the rest is what all points become in the end, or chance: then who leaves many points out is last.
void rank(std::vector<Plateau>& plateaus, std::size_t distinct) {
  double piece = std::numeric_limits<double>::infinity();
  for (const Plateau& p : plateaus)
    if (p.is_long && p.kind == PlateauKind::one_piece) piece = std::min(piece, p.from);
  const auto tier = [&](const Plateau& p) {
    if (!p.is_long) return 2;
    if (p.kind == PlateauKind::structured) return p.from < piece ? 0 : 1;
    return p.from == piece ? 1 : 2;
  };
  const auto key = [&](const Plateau& p) {
    const bool leaves_out = !p.is_long && !is_share(p.step.covered, distinct, most);
    const double covered = static_cast<double>(p.step.covered) / static_cast<double>(distinct);
    return std::tuple(tier(p), leaves_out, -(p.ratio - 1) * covered, p.from);
  };
  std::sort(plateaus.begin(), plateaus.end(), [&](const Plateau& a, const Plateau& b) { return key(a) < key(b); });
}

}  // namespace

std::vector<Plateau> plateaus(const Delaunay& delaunay, const Filtration& filtration,
                              const std::function<bool()>& go_on) {
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
    return is_share(step.covered, filtration.distinct, least_share);
  });
  const StepRange all{static_cast<std::size_t>(begin - filtration.steps.begin()), filtration.steps.size()};
  const StillRanges ranges(alpha, std::move(change), reach_of(delaunay.points()));
  std::vector<Plateau> found;
  for (const StepRange& range : ranges.longest(all, most_plateaus, least_ratio))
    found.push_back(plateau_of(range, filtration, curve, ranges.ratio_of(range)));
  rank(found, filtration.distinct);
  return found;
}

}  // namespace rbpa
