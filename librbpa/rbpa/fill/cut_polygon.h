// What: cuts a polygon along a vertical line, such as the meridian at longitude 180, into its parts on either side.
// Law:  the parts on each side are valid polygons, whose points are points of the polygon or of the line. Their
//       topology is decided exactly; a crossing of an edge and the line is rounded, to the same number on both sides.
// Cost: n log n in the vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// The crossing of an edge and the line.
struct EdgeCrossing {
  std::uint32_t from, to;  ///< the ends of the edge, left and right of the line
  double share;            ///< position of the crossing, as a fraction from 0 at `from` to 1 at `to`
};

struct PolygonCut {
  std::vector<Point> points;            ///< the input points under their indices, then one for each crossing
  std::vector<EdgeCrossing> crossings;  ///< one for each added point, in the order of the points
  std::vector<Polygon> left, right;     ///< empty if no part of the polygon lies on that side
};

/// Cuts `polygon` along the vertical line at `x`.
/// Requires: a valid polygon (validity.h) on these points, whose shell is counter-clockwise and whose holes are
///           clockwise, as outline_polygons() returns them; a finite x.
/// Throws:   InvalidInput if the polygon is seen to be invalid, or if rounded crossings would make a part invalid.
RBPA_API PolygonCut cut_at(std::span<const Point> points, const Polygon& polygon, double x);

}  // namespace rbpa
