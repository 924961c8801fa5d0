// What: adds triangles of the plane, in any format, to the output files of a run.
#pragma once

#include <span>
#include <vector>

#include "io/mesh/write_triangles.h"
#include "io/point_file.h"
#include "shared/run.h"

namespace rbpa::app {

/// Adds a target with the triangles of `mesh`; `about` has the coordinate system of the points. Requires: target.format
/// is not a picture. Throws Failure, ClosedPipe, Cancelled.
void add_triangles(Run& run, const Target& target, const TriangleMesh& mesh, const PointFile& about);

/// Prints a warning, even with --quiet, if readers of a GeoJSON target may take the coordinates for degrees although
/// they are not.
void caution(const std::vector<Target>& targets, std::span<const Point> points, const PointFile& about);

}  // namespace rbpa::app
