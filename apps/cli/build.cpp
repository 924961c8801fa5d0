#include "cli/build.h"

#include "cli/progress.h"

namespace rbpa::app {

std::vector<Point> read(const PointSource& source, bool quiet) {
  const ProgressLine line("rbpa", !quiet && !read_from_terminal(source.path), "reading");
  return read_points(source);
}

SolidAlphaComplex build(const std::vector<Point>& points, double alpha, const RunOptions& run, Search search) {
  TriangleProgress progress(!run.quiet);
  return rbpa(points, alpha, {.search = search, .threads = run.threads, .progress = progress.watch()});
}

Triangulation build_arrays(const std::vector<Point>& points, double alpha, Complex kind, bool neighbors,
                           const RunOptions& run) {
  TriangleProgress progress(!run.quiet);
  return triangulate(points, alpha,
                     {.complex = kind, .neighbors = neighbors, .threads = run.threads, .progress = progress.watch()});
}

}  // namespace rbpa::app
