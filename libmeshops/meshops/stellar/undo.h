// What: undoes weld_edge(), weld_face(), collapse() and remove_vertex(); for flip() see flip.h. A split is undone by its
//       inverse operator, which restores all live records itself.
// Law:  undo(weld()) restores every live record of the mesh. A sound mesh stays sound, whatever the effect contains.
#pragma once

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/effect.h"

namespace meshops {

/// Brings back what an operator marked deleted, with its old handles and properties.
/// Effect:   split_vertex(left, right) with what was removed as its new elements. When the mesh is as the operator left
///           it, i.e. what was done since has been undone and no garbage was collected, that is the mesh before.
/// Requires: the elements are still there and marked; left and right leave the survivor, and can be split; the mesh has
///           status of every kind. All of this is checked.
/// Throws:   ContractViolation, mesh untouched.
/// Δ:        the opposite of effect.delta().
/// Cost:     the degree of the vertex; of the survivor where it is on the boundary.
MESHOPS_API void undo(Connectivity& mesh, const WeldEffect& effect);

}  // namespace meshops
