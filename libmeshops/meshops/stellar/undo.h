// What: undoes weld_edge(), weld_face(), collapse() and remove_vertex().
// Why:  a split is undone by its inverse operator, which restores all live records itself; a flip has its own undo().
// Law:  undo() of the returned effect restores every live record of the mesh. A sound mesh stays sound for any effect.
#pragma once

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"

namespace meshops {

/// Restores the elements that an operator marked deleted, with their old handles and properties.
/// Effect:   splits the survivor between `left` and `right` of the effect as split_vertex() does, with the removed
///           elements in place of new ones. The result is the mesh before the operator if the mesh is as the operator
///           left it, that is, if later changes have been undone and no garbage was collected.
/// Requires: the removed elements still exist and are marked deleted; split_vertex_blocker(left, right, Keep::manifold)
///           is empty; `left` and `right` leave the survivor; the mesh has status of every kind. All is checked.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Δ:        the opposite of effect.delta().
/// Cost:     the degree of the restored vertex; if the survivor is on the boundary, the degree of the survivor.
MESHOPS_API void undo(Connectivity& mesh, const WeldEffect& effect);

}  // namespace meshops
