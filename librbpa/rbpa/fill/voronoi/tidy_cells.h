// What: makes polygons of the loops of a planar map whose vertices were rounded.
// Law:  each cell becomes a valid multipolygon, and so does the region. The cells tile the region, as every change is
//       made in all cells alike.
// How:  where the rings of a cell meet otherwise than in single points, or turn the wrong way, the vertex nearest to an
//       edge there is put on the edge, or merged with its end. Edges that a cell passes in both directions are removed.
//       This is repeated until all rings are right. docs/explanation/plane.md, section 34.
#pragma once

#include "rbpa/base/run/steps.h"
#include "rbpa/fill/voronoi/cut_cells.h"
#include "rbpa/fill/voronoi_cells.h"

namespace rbpa {

/// Returns the polygons of the cells. Throws: Cancelled.
VoronoiCells tidy(CutCells cells, const GoOn& go_on);

}  // namespace rbpa
