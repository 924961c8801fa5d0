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

/// Returns why `f` cannot be destroyed, or nothing when it can. The reasons: the mesh lacks status of some kind, there
/// is no such face, it is no triangle, a side is glued to another face, or a corner has several fans (core/fans.h).
/// Cost:     constant.
MESHOPS_API std::optional<Blocker> destroy_triangle_blocker(const Connectivity& mesh, Face f);

/// Marks a triangle that is a component of its own as deleted, with its edges and vertices.
/// Returns:  delta_of_destroy().
/// Requires: destroy_triangle_blocker() is empty; the mesh has status of every kind.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Inverse:  create_triangle(), up to handles.
/// Cost:     constant.
MESHOPS_API Delta destroy_triangle(Connectivity& mesh, Face f);

/// Returns why `f` cannot be removed, or nothing when it can. The reasons: the mesh lacks status of some kind, there is
/// no such face, it is no triangle, or a corner has several fans (core/fans.h).
/// Cost:     the degrees of the corners that are on the boundary.
MESHOPS_API std::optional<Blocker> remove_triangle_blocker(const Connectivity& mesh, Face f);

/// Unglues the glued sides of a triangle and destroys the triangle. Where the remaining faces at a corner would touch
/// each other only there, the corner becomes two vertices with the same properties, one for each fan.
/// Effect:   the remaining edges and vertices keep their handles; a second fan gets a new vertex. Sides and corners
///           without another face are marked deleted.
/// Returns:  the change of the counts, with −1 for faces.
/// Requires: remove_triangle_blocker() is empty; the mesh has status of every kind.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Inverse:  insert_triangle() (insert_triangle.h), up to handles.
/// Cost:     the cost of unglue() for each glued side.
MESHOPS_API Delta remove_triangle(Connectivity& mesh, Face f);

}  // namespace meshops
