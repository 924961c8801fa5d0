// What: the cells of a Voronoi diagram as polygons within a boundary: a box, the convex hull, or any valid polygons.
// Law:  the cells tile: interiors are disjoint, neighbors share their vertices, and areas add up to that of the
//       boundary as written. Each cell is a valid multipolygon under OGC Simple Features.
//       docs/explanation/plane.md, section 33.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/polygon.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/delaunay.h"

namespace rbpa {

/// The parts of the cells within a boundary. A cell may have none, and several where the boundary is not convex.
struct VoronoiCells {
  std::vector<Point> points;      ///< the corners, each once, in lexicographic order, and points merged with them
  std::vector<Polygon> polygons;  ///< by cell; those of one cell in the order of outline_polygons()
  std::vector<std::uint32_t>
      of;                    ///< for each polygon the input point of its cell, ascending; of equal points the first
  std::size_t merged = 0;    ///< number of vertices that were merged with others because of rounding
  std::size_t inserted = 0;  ///< number of vertices that were put on edges of other cells because of rounding
};

/// Returns the cells of the distinct points of `delaunay` within `boundary`, whose rings are indices into
/// `boundary_points`. Which cells and edges meet is decided exactly. Corners are those of the boundary, and the real
/// vertices and crossings, each coordinate rounded once. Where rounding makes rings cross, vertices are merged with
/// others or put on edges, in all cells alike, and cells that have no area left vanish. A corner moves only so; the
/// boundary is that of the cells together, whose edges are rounded where ridges cross them.
/// Requires: `boundary` is a valid multipolygon. The convex hull is outline_polygons() of the triangulation.
/// Throws:   InvalidInput with the text of why_invalid() when it is not; Cancelled.
/// Cost:     linear in the points; for each ridge that crosses the boundary, linear in the ridges of its cells.
RBPA_API VoronoiCells voronoi_cells(const Delaunay& delaunay, std::span<const Point> boundary_points,
                                    std::span<const Polygon> boundary, const GoOn& go_on = {});

/// Returns the corners of the points' bounding box, counter-clockwise. The box is larger on each side by a tenth of its
/// longer side; where this is 0, by a tenth of the larger coordinate, or by 1. Coordinates stay finite.
/// Requires: one or more points.
RBPA_API std::array<Point, 4> box_around(std::span<const Point> points);

}  // namespace rbpa
