// What: how much the solid alpha complex has changed, at every step of its filtration.
// Law:  each number is one of the set of points alone, and of no unit: sums are computed in an order that coordinates
//       determine.
// How:  docs/which_alpha.md.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/delaunay.h"
#include "rbpa/filtration.h"

namespace rbpa {

/// At one step of the filtration.
struct ShapeState {
  long double change;      ///< never less than at the step before
  double effective_parts;  ///< (Σ nᵢ)² / Σ nᵢ², of the vertices in solid components
  double hole_share;       ///< area of holes / area of triangles and holes
};

/// One for every step. Requires and throws: as plateaus().
std::vector<ShapeState> shape_curve(const Delaunay& of, const Filtration& filtration, Steps& pulse);

}  // namespace rbpa
