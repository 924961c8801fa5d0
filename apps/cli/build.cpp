#include "cli/build.h"

#include "cli/progress.h"
#include "rbpa/collinear.h"

namespace rbpa::app {

SolidAlphaComplex build(const std::vector<Point>& points, double alpha, const RunOptions& run, Search search) {
  ProgressLine line(!run.quiet);
  return rbpa(points, alpha, {.search = search, .threads = run.threads, .progress = line.watch()});
}

std::string reason_for_empty(const std::vector<Point>& points, std::size_t distinct, const std::string& alpha) {
  if (distinct < 3) return "fewer than three distinct points (" + std::to_string(distinct) + ")";
  if (are_collinear(points)) return "all points are collinear";
  return "no triangle has circumradius <= " + alpha;
}

}  // namespace rbpa::app
