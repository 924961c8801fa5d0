// What: estimates the number of triangles that fill polygons, before the first is made.
// Law:  the estimate is the sum over the groups of max(∫ 4 / (√3 h²) over the polygons, ∫ 1 / h along their edges, at
//       least 1 for each), where h is the size field. The integrals are computed from pieces; around the middle of each
//       piece, h is bounded by its slope. The errors of the integrals are at most a tenth if 2¹⁷ pieces, and 64 for
//       each edge and triangle, suffice for that. If not, as in slivers, the lower bounds of the pieces are added up,
//       and the estimate may be far too low. fill() makes between half and three times as many triangles if sizes
//       change little within one triangle (docs/explanation/plane.md, section 28); short edges of the boundary that no
//       grade respects make more.
// Cost: that of the constrained Delaunay triangulations, and a query of the field for each edge, triangle and piece.
#pragma once

#include <span>

#include "rbpa/fill/front/outline.h"
#include "rbpa/fill/front/size_field.h"

namespace rbpa {

/// Returns the estimated number of triangles. `groups` are the outlines of all groups, not cut yet. With
/// `keep_boundary`, each boundary edge counts as one piece.
/// Throws: Cancelled.
double estimate_triangles(std::span<const OutlinePart> groups, const SizeField& field, bool keep_boundary,
                          const GoOn& go_on);

}  // namespace rbpa
