#include "cli/build.h"

#include <optional>

#include "cli/progress.h"
#include "io/failure.h"

namespace rbpa::app {

PointFile read(const PointSource& source, bool quiet) {
  std::optional<ProgressLine> line(std::in_place, "rbpa", !quiet && !read_from_terminal(source.path), "reading");
  PointFile file = read_points(source);
  line.reset();
  const std::string name = source.path == "-" ? "standard input" : source.path;
  for (const std::string& remark : file.remarks)
    if (!quiet) say("rbpa", name + ": " + remark);
  if (file.heights.differ() && !quiet)
    say("rbpa",
        name + ": z of " + counted(file.points.size(), "point") + " was ignored (rbpa surface computes in space)");
  return file;
}

Delaunay build_delaunay(const std::vector<Point>& points, const RunOptions& run) {
  TriangleProgress progress(!run.quiet);
  return Delaunay(points, {.threads = run.threads, .progress = progress.watch()});
}

Triangulation build_arrays(const std::vector<Point>& points, double alpha, Complex kind, bool neighbors,
                           const RunOptions& run) {
  TriangleProgress progress(!run.quiet);
  return triangulate(points, alpha,
                     {.complex = kind, .neighbors = neighbors, .threads = run.threads, .progress = progress.watch()});
}

}  // namespace rbpa::app
