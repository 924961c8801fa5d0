// What: measures how much the solid alpha complex has changed, at every step of its filtration.
// Law:  each number depends on the set of points alone, and has no unit: sums are computed in an order that coordinates
//       determine.
// How:  docs/explanation/filtration_and_persistence.md, sections 6 and 7.
#pragma once

#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"

namespace rbpa {

/// The state at one step of the filtration.
struct ShapeState {
  long double change;      ///< never less than at the step before
  double effective_parts;  ///< (Σ nᵢ)² / Σ nᵢ², of the vertices in solid components
  double hole_share;       ///< area of holes / area of triangles and holes
};

/// Returns the state after each step, in order. Calls pulse() for each triangle.
/// Requires: as plateaus().
/// Throws:   as plateaus().
std::vector<ShapeState> shape_curve(const Delaunay& of, const Filtration& filtration, Steps& pulse);

}  // namespace rbpa
