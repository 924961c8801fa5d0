// What: cuts a polygon along a vertical line, such as the meridian at longitude 180, into its parts on both sides.
// Law:  the parts on each side are valid polygons, whose points are vertices of the polygon and its crossings with the
//       line. Their topology is decided exactly. A crossing of an edge and the line is rounded, to one point for both
//       sides. A part that has fewer than three different points after rounding is left out.
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
  std::uint32_t from, to;  ///< the ends of the edge: `from` left, `to` right of the line
  double share;            ///< position of the crossing on the edge, from 0 at `from` to 1 at `to`
};

/// The parts of a polygon on both sides of a line, on one list of points.
struct PolygonCut {
  std::vector<Point> points;            ///< the input points with their indices, then one point for each crossing
  std::vector<EdgeCrossing> crossings;  ///< one for each added point, in the order of the points
  /// The parts on each side, in no particular order: shells counter-clockwise, holes clockwise, each ring from its
  /// lexicographically least point on. Empty if the side has no part of the polygon, or only parts that rounding
  /// removes.
  std::vector<Polygon> left, right;
};

/// Cuts `polygon` along the vertical line at `x`, in units of the points.
/// Requires: a valid polygon (validity.h) with a counter-clockwise shell and clockwise holes, as outline_polygons()
///           returns; rings of indices into `points`; finite coordinates; a finite x. Only some violations are found.
/// Throws:   InvalidInput if the polygon is found to be invalid, or if rounded crossings would make a part invalid.
RBPA_API PolygonCut cut_at(std::span<const Point> points, const Polygon& polygon, double x);

}  // namespace rbpa
