// What: adds triangles of the plane, in any format, to the files that a run writes.
#pragma once

#include <span>
#include <vector>

#include "io/mesh/write_triangles.h"
#include "io/point_file.h"
#include "shared/run.h"

namespace rbpa::app {

/// Adds a target; `about` has the coordinate system of the points. Requires: target.format is not a picture. Throws
/// Failure, ClosedPipe, Cancelled.
void add_triangles(Run& run, const Target& target, const TriangleMesh& mesh, const PointFile& about);

/// Prints a warning, also with --quiet, if readers of a GeoJSON target may take coordinates for degrees that are not
/// degrees.
void caution(const std::vector<Target>& targets, std::span<const Point> points, const PointFile& about);

}  // namespace rbpa::app
