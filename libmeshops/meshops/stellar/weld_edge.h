// What:   the stellar operator that removes a vertex from an edge; the inverse of split_edge().
// Law:    split_edge(weld_edge(h).line) restores the mesh up to handles; undo() restores all live records.
// Source: Alexander, The combinatorial theory of complexes (1930); Lewiner et al., section on stellar operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/keep.h"

namespace meshops {

struct WeldEdgeEffect : WeldEffect {
  Halfedge line{};  ///< the halfedge of the merged edge that ends at the survivor
};

/// Returns why the start of h cannot be welded into the edge, or nothing when it can. The reasons: h does not exist or
/// is deleted; the start of h is inner and does not have four edges; the start is on the boundary, and it does not have
/// three edges or the edge of h is not on the boundary; a face at the start is not a triangle; or any reason of
/// collapse_blocker().
/// Cost: constant; with Keep::simplicial, the degree of the end of h.
MESHOPS_API std::optional<Blocker> weld_edge_blocker(const Connectivity& mesh, Halfedge h,
                                                     Keep keep = Keep::simplicial);

/// Removes the vertex v of h = v→b and all edges of v except the edge a–v opposite to h, which becomes a–b.
/// Effect:      v, the edge of h, the edges from v to the apexes, and the faces at h are marked deleted; the faces at
///              the edge a–v take the places of the deleted faces.
/// Requires:    weld_edge_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the elements marked deleted; a, b, the edge a–v and the faces at a survive.
/// Inverse:     split_edge() of `line`, up to handles; undo(), exactly.
/// Δ:           V −1, E −3, F −2; on the boundary V −1, E −2, F −1. The topology does not change.
/// Cost:        the cost of weld_edge_blocker().
MESHOPS_API WeldEdgeEffect weld_edge(Connectivity& mesh, Halfedge h, Keep keep = Keep::simplicial);

}  // namespace meshops
