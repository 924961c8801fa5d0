// What:   the operator that removes a vertex by the collapse of one of its edges.
// Law:    remove_vertex() equals the collapse of the first halfedge of the vertex that can be collapsed.
// Source: Lewiner et al., section on stellar operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/keep.h"

namespace meshops {

/// Returns why the vertex cannot be removed, or nothing when it can. The reasons: the mesh lacks status of some kind;
/// the vertex does not exist or is deleted; it is isolated; or no halfedge that leaves the vertex can be collapsed. In
/// the last case, the result is that of collapse_blocker() for mesh.halfedge_handle(v).
/// Cost: the cost of collapse_blocker() for each halfedge up to the first that can be collapsed.
MESHOPS_API std::optional<Blocker> remove_vertex_blocker(const Connectivity& mesh, Vertex v,
                                                         Keep keep = Keep::simplicial);

/// Collapses the first halfedge that leaves v and has no blocker. The halfedges are tried clockwise from
/// mesh.halfedge_handle(v) on, in the order of mesh.voh_range(v).
/// Requires:    remove_vertex_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the elements marked deleted, which are `removed` in the effect.
/// Inverse:     split_vertex(left, right) of the returned effect, up to handles; undo(), exactly.
/// Δ:           V −1, E −3, F −2; for a boundary edge V −1, E −2, F −1. The topology does not change.
/// Cost:        the cost of remove_vertex_blocker().
MESHOPS_API WeldEffect remove_vertex(Connectivity& mesh, Vertex v, Keep keep = Keep::simplicial);

}  // namespace meshops
