// What:   the handle operator that ends a component; and the one that removes a triangle from any.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <optional>
#include <string>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"
#include "meshops/handle/effect.h"

namespace meshops {

/// Why `f` cannot be destroyed, or nothing when it can: no such face, other than three sides, a side that is glued to
/// another face, or a corner with several fans (core/fans.h).
MESHOPS_API std::optional<std::string> destroy_triangle_blocker(const Connectivity& mesh, Face f);

/// Marks a triangle that is a component of its own as deleted, with its edges and vertices.
/// Returns:  delta_of_destroy().
/// Requires: destroy_triangle_blocker() is empty; the mesh has status of every kind.
/// Throws:   ContractViolation, mesh untouched.
/// Inverse:  create_triangle(), up to handles.
/// Cost:     constant.
MESHOPS_API Delta destroy_triangle(Connectivity& mesh, Face f);

/// Why `f` cannot be removed, or nothing when it can: no such face, other than three sides, or a corner with several
/// fans (core/fans.h).
/// Cost:     the degrees of the corners that are on the boundary.
MESHOPS_API std::optional<std::string> remove_triangle_blocker(const Connectivity& mesh, Face f);

/// Unglues the sides of a triangle that are glued, and destroys it. Where the rest would touch itself in a corner, the
/// corner becomes a vertex for each of its fans, with the same properties.
/// Effect:   the vertices and edges of the rest keep their handles, but for further fans, which get new vertices.
/// Returns:  what it did to the counts: ΔF is −1.
/// Requires: remove_triangle_blocker() is empty; the mesh has status of every kind.
/// Throws:   ContractViolation, mesh untouched.
/// Inverse:  insert_triangle(), up to handles.
/// Cost:     that of up to three unglue().
MESHOPS_API Delta remove_triangle(Connectivity& mesh, Face f);

}  // namespace meshops
