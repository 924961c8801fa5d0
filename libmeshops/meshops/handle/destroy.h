// What:   the handle operator that removes a component of one triangle, and the operator that removes any triangle.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"
#include "meshops/handle/effect.h"

namespace meshops {

/// Returns why `f` cannot be destroyed, or nothing when it can. The reasons: the mesh lacks status of some kind, the
/// face does not exist or is deleted, it is not a triangle, another face lies beyond one of its sides, or a corner has
/// several fans (core/fans.h).
/// Cost:     constant.
MESHOPS_API std::optional<Blocker> destroy_triangle_blocker(const Connectivity& mesh, Face f);

/// Marks a triangle that is the only face of its component as deleted, together with its edges and vertices.
/// Returns:  delta_of_destroy().
/// Requires: destroy_triangle_blocker() is empty.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Inverse:  create_triangle(), up to handles.
/// Cost:     constant.
MESHOPS_API Delta destroy_triangle(Connectivity& mesh, Face f);

/// Returns why `f` cannot be removed, or nothing when it can. The reasons: the mesh lacks status of some kind, the face
/// does not exist or is deleted, it is not a triangle, or a corner has several fans (core/fans.h).
/// Cost:     the degrees of the corners that are on the boundary.
MESHOPS_API std::optional<Blocker> remove_triangle_blocker(const Connectivity& mesh, Face f);

/// Unglues a triangle from the faces beyond its sides, and destroys the triangle. A corner becomes two vertices with
/// the same properties, one for each fan, if its remaining faces would form two fans.
/// Effect:   the remaining edges and vertices keep their handles; a second fan gets a new vertex. Sides and corners
///           without another face are marked deleted.
/// Returns:  the change of the counts, in which faces change by −1.
/// Requires: remove_triangle_blocker() is empty.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Inverse:  insert_triangle() (insert_triangle.h), up to handles.
/// Cost:     the cost of an unglue() for each side with a face beyond it.
MESHOPS_API Delta remove_triangle(Connectivity& mesh, Face f);

}  // namespace meshops
