// What: takes back weld_edge(), weld_face(), collapse() and remove_vertex(); for flip() see flip.h. What takes back a
//       split is its inverse operator, which restores all live records itself.
// Law:  undo(weld()) restores every live record of the mesh.
#pragma once

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/effect.h"

namespace meshops {

/// Brings back what an operator marked deleted, with its old handles and properties.
/// Requires: the mesh is as the operator left it: what was done since has been undone, and no garbage was collected.
///           Checked is only that the elements are still there and marked.
/// Throws:   ContractViolation, mesh untouched.
/// Δ:        the opposite of effect.delta().
/// Cost:     the degree of the vertex.
MESHOPS_API void undo(Connectivity& mesh, const WeldEffect& effect);

}  // namespace meshops
