// What:   a polygon cut along a vertical line, as longitude 180 is one.
// Law:    what lies on a side are valid polygons, whose points are those of the polygon and points of the line. Which they are is
//         decided exactly; a point where an edge crosses the line is rounded, the same on both sides.
// Cost:   n log n in the vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/shape.h"

namespace rbpa {

/// The crossing of an edge and the line.
struct EdgeCrossing {
  std::uint32_t from, to;  ///< the ends of the edge, left and right of the line
  double share;            ///< of the way from one to the other
};

struct PolygonCut {
  std::vector<Point> points;            ///< those of the input, each under its index, then one for each crossing
  std::vector<EdgeCrossing> crossings;  ///< of each of these
  std::vector<Polygon> left, right;     ///< empty where nothing of the polygon lies on a side
};

/// Requires: a valid polygon (validity.h) whose shell turns counter-clockwise and whose holes turn clockwise, as polygons() has
///           them, on these points; a finite x.
/// Throws:   InvalidInput that names the place: where rounded crossings would make a part invalid, and as polygons_of_rings().
RBPA_API PolygonCut cut_at(std::span<const Point> points, const Polygon& polygon, double x);

}  // namespace rbpa
