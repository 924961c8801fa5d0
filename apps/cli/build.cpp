#include "cli/build.h"

#include <algorithm>

#include "cli/progress.h"
#include "io/interrupt.h"
#include "rbpa/predicate/predicates.h"

namespace rbpa::app {
namespace {

bool all_on_a_line(const std::vector<Point>& points) {
  const auto other = std::find_if(points.begin(), points.end(), [&](const Point& p) { return !(p == points[0]); });
  return std::all_of(points.begin(), points.end(),
                     [&](const Point& p) { return Predicates<long double>::orientation(points[0], *other, p) == 0; });
}

}  // namespace

SolidAlphaComplex build(const std::vector<Point>& points, double alpha, Options options, bool quiet) {
  ProgressLine line(!quiet);
  options.progress = [&](const Progress& progress) {
    line.show(progress);
    return !interrupted();
  };
  return rbpa(points, alpha, options);
}

std::string reason_for_empty(const std::vector<Point>& points, std::size_t distinct, const std::string& alpha) {
  if (distinct < 3) return "fewer than three distinct points (" + std::to_string(distinct) + ")";
  if (all_on_a_line(points)) return "all points are collinear";
  return "no triangle has circumradius <= " + alpha;
}

}  // namespace rbpa::app
