// What: numbers the triangles and the edges of a triangulation, and finds which are faces of which.
// How:  a triangle is numbered by the first of its tetrahedra; an edge by the first of its triangles, in a table of the edges up from its lesser
//       corner, which is short and stays in the caches where the corners of tetrahedra that follow each other are near each other:
//
//           corner     0        1      2 …
//           slots   | · 3 · 7 | · 12 | 5 · …     of each at least half as many as triangles have an edge up from it, and one more
//
// Cost: linear; twenty bytes a triangle for the tables.
#pragma once

#include <cstddef>

#include "rbpa/base/steps.h"
#include "rbpa/solid_filtration.h"

namespace rbpa::space {

/// From `delaunay`, fills in triangles, edges, triangles_of and edges_of. Requires: neighbors; corners below `points`.
void number_faces(std::size_t points, Steps& step, SolidFiltration& filtration);

}  // namespace rbpa::space
