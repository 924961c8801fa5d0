// What: reads the lines of a file as segments, and triangulates points with them: every segment becomes edges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rbpa/plane/constrained_delaunay.h"
#include "shared/arguments.h"
#include "shared/run.h"
#include "shared/verbs.h"

namespace rbpa::app {

struct SegmentSource {
  PointSource lines;
  bool split_crossings;
};

/// Parses the options. The lines have the coordinate system that --crs gives the points, and are shifted like the
/// points. Throws WrongUsage that names a format without lines, standard input for two files, or an output that is the
/// file of lines.
std::optional<SegmentSource> parse_segments(const SegmentArguments& arguments, const PointSource& points,
                                            const std::vector<Target>& targets, const OutputArguments& outputs);

/// Reads the lines, and returns the constrained Delaunay triangulation of the points and the sides of the lines.
/// Appends to `file` the vertices of the lines, and the places at which sides were split, so that its points are those
/// of the triangulation. If the points have heights, a vertex without one gets that of the triangles of the points, or
/// of the nearest place of their hull, and a split place the mean of the heights of two segments there. Shows a
/// progress line unless quiet.
/// Throws: BadInput that names a side, such as one that crosses another; BadInput, Failure and Cancelled as
///         read_points() does.
ConstrainedDelaunay triangulate_with_segments(const Run& run, const SegmentSource& source, PointFile& file);

/// Returns ", 20 edges on segments, 2 crossings split" for a summary.
std::string text_of_segments(const ConstrainedDelaunay& made);

}  // namespace rbpa::app
