// What:   about how many triangles polygons take, before one is made.
// Law:    max(∫ 4 / (√3 h²) over the polygons, ∫ 1 / h along their edges, at least 1 for each), where h is the size field.
//         Both integrals are off by no more than a tenth where 2¹⁷ pieces suffice for that: h is known within what its slope
//         allows around the middle of each. Where they do not, the estimate may be far too low or too high.
//         fill() adds those of its groups up. It makes between half and three times as many where sizes change little
//         within one triangle (docs/fill.md); short edges of the boundary that no grade respects make more.
// Cost:   that of the constrained Delaunay triangulation, and a question to the field for each edge and piece.
#pragma once

#include <functional>

#include "rbpa/fill/outline.h"
#include "rbpa/fill/size_field.h"

namespace rbpa {

/// The outline before it is cut. Throws Cancelled, where go_on returns false.
double estimate_triangles(const Outline& outline, const SizeField& field, bool keep_boundary,
                          const std::function<bool()>& go_on);

}  // namespace rbpa
