// What: undoes weld_edge(), weld_face(), collapse() and remove_vertex(); for flip() see flip.h. A split is undone by
//       its inverse operator, which restores all live records itself.
// Law:  undo() of the returned effect restores every live record of the mesh. A sound mesh stays sound, whatever the
//       effect contains.
#pragma once

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"

namespace meshops {

/// Restores the elements that an operator marked deleted, with their old handles and properties.
/// Effect:   the survivor is split between `left` and `right` of the effect, as by split_vertex(), with the removed
///           elements in place of new ones. If the mesh is as the operator left it (later changes have been undone, and
///           no garbage was collected), the result is the mesh before the operator.
/// Requires: the elements still exist and are marked deleted; split_vertex_blocker(left, right, Keep::manifold) is
///           empty, and both leave the survivor; the mesh has status of every kind. All of this is checked.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Δ:        the opposite of effect.delta().
/// Cost:     the degree of the restored vertex, or of the survivor where the survivor is on the boundary.
MESHOPS_API void undo(Connectivity& mesh, const WeldEffect& effect);

}  // namespace meshops
