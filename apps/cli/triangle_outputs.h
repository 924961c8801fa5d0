// What: triangles of the plane among the files that a run writes, in any format.
#pragma once

#include <span>
#include <vector>

#include "cli/run.h"
#include "io/mesh/write_triangles.h"
#include "io/point_file.h"

namespace rbpa::app {

/// Adds a target of triangles, not of a picture; `about` the points says their system. Throws Failure, Cancelled.
void add_triangles(Run& run, const Target& target, const TriangleMesh& mesh, const PointFile& about);

/// GeoJSON in meters looks like any other: says so, whatever else is not said.
void caution(const std::vector<Target>& targets, std::span<const Point> points, const PointFile& about);

}  // namespace rbpa::app
