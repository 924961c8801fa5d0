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

/// The measures of the complex at one step of its filtration.
struct ShapeState {
  long double change;      ///< the change up to this step, as plateaus() defines it; never falls
  double effective_parts;  ///< (Σ nᵢ)² / Σ nᵢ², with nᵢ the vertices of each solid component
  double hole_share;       ///< area of holes / area of triangles and holes
};

/// Returns the state after each step, in order; empty without a triangle. Counts each triangle as steps.
/// Requires: `filtration` is filtration(of).
/// Throws:   Cancelled.
std::vector<ShapeState> shape_curve(const Delaunay& of, const Filtration& filtration, Steps& pulse);

}  // namespace rbpa
