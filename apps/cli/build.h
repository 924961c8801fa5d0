// What: the points and the complex of a run, watched: progress on a terminal, Ctrl-C heard.
#pragma once

#include <vector>

#include "cli/run_options.h"
#include "io/cloud/read_points.h"
#include "rbpa/delaunay.h"
#include "rbpa/triangulate.h"

namespace rbpa::app {

/// read_points() with a progress line, what there is to remark, and that heights are left out, unless quiet.
PointFile read(const PointSource& source, bool quiet);

/// The Delaunay triangulation, of which radii are chosen, with a progress line unless quiet. Throws Cancelled
/// after a signal.
Delaunay build_delaunay(const std::vector<Point>& points, const RunOptions& run);

/// triangulate(), with neighbours if asked for, and a progress line unless quiet. Throws Cancelled after a signal.
Triangulation build_arrays(const std::vector<Point>& points, double alpha, Complex kind, bool neighbors,
                           const RunOptions& run);

}  // namespace rbpa::app
