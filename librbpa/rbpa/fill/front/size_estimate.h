// What: estimates the number of triangles that fill() makes, before it makes the first.
// Law:  let h be the size field. The estimate is the sum over the groups of the larger of two integrals: ∫ 4 / (√3 h²)
//       over the polygons, and ∫ 1 / h along their edges, where each edge counts at least 1. Integrals are computed
//       from pieces; the slope of h bounds h around the middle of each piece. The error of an integral is at most a
//       tenth if 2¹⁷ pieces plus 64 for each edge or triangle suffice. If not, as in slivers, the lower bounds of the
//       pieces are added up, and the estimate may be far too low. fill() makes between half and three times the
//       estimated number if sizes change little within one triangle (docs/explanation/plane.md, section 28), and more
//       at short boundary edges if no grade is given.
// Cost: that of the constrained Delaunay triangulations, and a query of the field for each edge, triangle and piece.
#pragma once

#include <span>

#include "rbpa/fill/front/outline.h"
#include "rbpa/fill/front/size_field.h"

namespace rbpa {

/// Returns the estimated number of triangles. `groups` are the outlines of all groups, before cut(). With
/// `keep_boundary`, the integral along each boundary edge counts as 1.
/// Throws: Cancelled.
double estimate_triangles(std::span<const OutlinePart> groups, const SizeField& field, bool keep_boundary,
                          const GoOn& go_on);

}  // namespace rbpa
