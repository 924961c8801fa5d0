// What: the cells of a Voronoi diagram cut by rings, as loops of vertices that are not rounded yet.
// Law:  the loops are those of a planar map: cells and rings in general position, which the real ones become when the
//       rings are moved by (ε, ε²), for small ε > 0. Each edge is passed once in each direction, but for edges on
//       rings.
// How:  each ring is walked from cell to cell. A step needs two exact signs: through which ridge the line of the ring's
//       edge leaves the cell, and whether the edge ends before. The rest follows from the order of the crossings.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/polygon.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/fill/voronoi_cells.h"
#include "rbpa/plane/delaunay.h"

namespace rbpa {

struct CutCells {
  std::vector<Point> points;   ///< vertices, rounded once; equal ones are one, in lexicographic order
  std::vector<bool> is_given;  ///< for each vertex whether it is a corner of a ring
  /// The loops around the parts of cells, with the part on the left, and the input point of the cell of each,
  /// ascending; and the loops around the whole region, which have no_index.
  std::vector<Ring> loops;
  std::vector<std::uint32_t> of;
};

/// Cuts the cells by `rings`, which have the region to keep on their left.
/// Requires: rings of a valid multipolygon. Throws: Cancelled.
CutCells cut_cells(const Delaunay& delaunay, std::span<const Point> points, std::span<const Ring> rings, Steps& step);

/// Makes polygons of the loops, whose vertices are rounded now: tidy_cells.cpp. Each cell becomes a valid multipolygon,
/// and so does the region; the cells tile the region, as every change is made in all cells alike. Throws: Cancelled.
VoronoiCells tidy(CutCells cells, const GoOn& go_on);

}  // namespace rbpa
