// What: finds the neighbors of triangles that fill groups of polygons.
#pragma once

#include "rbpa/fill/filling.h"

namespace rbpa {

/// Fills in `neighbors`.
/// Requires: points, triangles and their groups; the triangles of one group meet in whole edges.
/// Cost:     n log n.
void link(Filling& filling);

}  // namespace rbpa
