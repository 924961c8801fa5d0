#include "cli/build.h"

#include "cli/progress.h"
#include "rbpa/collinear.h"

namespace rbpa::app {

std::vector<Point> read(const PointSource& source, bool quiet) {
  const ProgressLine line("rbpa", !quiet && !read_from_terminal(source.path), "reading");
  return read_points(source);
}

SolidAlphaComplex build(const std::vector<Point>& points, double alpha, const RunOptions& run, Search search) {
  TriangleProgress progress(!run.quiet);
  return rbpa(points, alpha, {.search = search, .threads = run.threads, .progress = progress.watch()});
}

std::string reason_for_empty(const std::vector<Point>& points, std::size_t distinct, const std::string& alpha) {
  if (distinct < 3) return "fewer than three distinct points (" + std::to_string(distinct) + ")";
  if (are_collinear(points)) return "all points are collinear";
  return "no triangle has circumradius <= " + alpha;
}

}  // namespace rbpa::app
