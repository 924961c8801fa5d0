// What: the points and the complex of a run, watched: progress on a terminal, Ctrl-C heard, and in words why it is empty.
#pragma once

#include <string>
#include <vector>

#include "cli/run_options.h"
#include "io/read_points.h"
#include "rbpa/rbpa.h"

namespace rbpa::app {

/// read_points() with a progress line unless quiet.
std::vector<Point> read(const PointSource& source, bool quiet);

/// rbpa() with a progress line unless quiet. Throws Cancelled after a signal.
SolidAlphaComplex build(const std::vector<Point>& points, double alpha, const RunOptions& run,
                        Search search = Search::near_to_far);

/// Why the complex of these points has no triangle. `alpha` as the user wrote it.
std::string reason_for_empty(const std::vector<Point>& points, std::size_t distinct, const std::string& alpha);

}  // namespace rbpa::app
