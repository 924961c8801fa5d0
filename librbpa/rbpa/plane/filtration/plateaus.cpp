#include "rbpa/plateaus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "rbpa/base/steps.h"
#include "rbpa/covering.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/shape_curve.h"

namespace rbpa {
namespace {

constexpr long double tolerance = 1.1L;   // how much the change may grow within a plateau
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

/// Steps from `first` up to `last`, which is not in it.
struct Range {
  std::size_t first, last;
};

class StillRanges {
 public:
  StillRanges(const Filtration& filtration, std::vector<ShapeState> curve, double reach)
      : steps_(filtration.steps), curve_(std::move(curve)), reach_(reach), noise_(noise_ratio(filtration.distinct)) {}

  /// The longest range in which the change stays within the tolerance; of equally long ones the first.
  Range longest(const Range& within) const {
    Range longest{within.first, within.first};
    double greatest = 0;
    std::size_t last = within.first;
    for (std::size_t first = within.first; first < within.last; ++first) {
      while (last < within.last && curve_[last].change <= tolerance * curve_[first].change) ++last;
      const double ratio = ratio_of({first, last});
      if (ratio > greatest) {
        greatest = ratio;
        longest = {first, last};
      }
    }
    return longest;
  }

  double ratio_of(const Range& range) const {
    const double from = steps_[range.first].alpha;
    const double to = range.last == steps_.size() ? reach_ : std::min(reach_, steps_[range.last].alpha);
    return std::max(1.0, to / from);
  }

  Plateau plateau_of(const Range& range) const {
    Plateau plateau{.from = steps_[range.first].alpha, .ratio = ratio_of(range)};
    if (range.last < steps_.size()) plateau.to = steps_[range.last].alpha;
    plateau.alpha = plateau.from * std::min(std::sqrt(plateau.ratio), plateau_settles);
    const auto after = std::upper_bound(steps_.begin(), steps_.end(), plateau.alpha,
                                        [](double alpha, const FiltrationStep& step) { return alpha < step.alpha; });
    const auto at = static_cast<std::size_t>(after - steps_.begin()) - 1;
    plateau.step = steps_[at];
    plateau.effective_parts = curve_[at].effective_parts;
    plateau.hole_share = curve_[at].hole_share;
    if (plateau.effective_parts >= one_part || plateau.hole_share >= small_holes)
      plateau.kind = PlateauKind::structured;
    plateau.is_long = plateau.ratio >= noise_;
    return plateau;
  }

 private:
  const std::vector<FiltrationStep>& steps_;
  std::vector<ShapeState> curve_;
  double reach_;
  double noise_;
};

/// Ranges that have no alpha in common, the longest first, each the longest of what the ones before have left.
std::vector<Range> longest_ranges(const StillRanges& ranges, const Range& all) {
  struct Left {
    Range range, longest;
    double ratio;
  };
  std::vector<Left> left;
  const auto leave = [&](const Range& range) {
    if (range.first == range.last) return;
    const Range longest = ranges.longest(range);
    left.push_back({range, longest, ranges.ratio_of(longest)});
  };
  std::vector<Range> found;
  leave(all);
  while (found.size() < most_plateaus && !left.empty()) {
    const auto next =
        std::max_element(left.begin(), left.end(), [](const Left& a, const Left& b) { return a.ratio < b.ratio; });
    if (next->ratio < least_ratio && !found.empty()) break;
    const auto [range, longest, ratio] = *next;
    left.erase(next);
    found.push_back(longest);
    leave({range.first, longest.first});
    leave({longest.last, range.last});
  }
  return found;
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
  std::vector<ShapeState> curve = shape_curve(delaunay, filtration, pulse);
  if (curve.empty()) return {};
  const auto begin = std::find_if(filtration.steps.begin(), filtration.steps.end(), [&](const FiltrationStep& step) {
    return is_share(step.covered, filtration.distinct, least_share);
  });
  const Range all{static_cast<std::size_t>(begin - filtration.steps.begin()), filtration.steps.size()};
  const StillRanges ranges(filtration, std::move(curve), reach_of(delaunay.points()));
  std::vector<Plateau> found;
  for (const Range& range : longest_ranges(ranges, all)) found.push_back(ranges.plateau_of(range));
  rank(found, filtration.distinct);
  return found;
}

}  // namespace rbpa
