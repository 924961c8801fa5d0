// What:   the stellar operator that rotates an edge inside its two triangles.
// Law:    two flips of an edge restore the mesh, except that the edge is reversed and its two faces are exchanged.
//         undo(flip()) restores every record.
// Source: Pachner, P.L. homeomorphic manifolds are equivalent by elementary shellings (1991).
#pragma once

#include <array>
#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"
#include "meshops/stellar/keep.h"

namespace meshops {

struct FlipEffect {
  Edge edge{};
  std::array<Halfedge, 2> named = {
      Halfedge(), Halfedge()};  ///< for undo(): the former halfedges of the start and of the end of halfedge 0
  constexpr Delta delta() const { return {}; }
};

/// Returns why the edge cannot be flipped, or nothing when it can. The reasons: the edge does not exist or is deleted;
/// it is on the boundary; a face at the edge is not a triangle; both triangles have the same apex, so that the edge
/// would become a loop; or, with Keep::simplicial, an edge joins the two apexes already.
/// Cost: constant; with Keep::simplicial, the lesser degree of the two apexes.
MESHOPS_API std::optional<Blocker> flip_blocker(const Connectivity& mesh, Edge e, Keep keep = Keep::simplicial);

/// Rotates the edge counter-clockwise in the quadrangle of its two triangles.
/// Effect:      a halfedge a→b with the apex c on the left and d on the right becomes d→c. The face on the left stays
///              on the left and keeps the side c→a; the other face keeps d→b.
/// Requires:    flip_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: nothing.
/// Inverse:     flip(), except that the edge is reversed and its faces are exchanged; undo(), exactly.
/// Δ:           all 0; the degrees of a and b fall by one, the degrees of c and d rise by one.
/// Cost:        the cost of flip_blocker().
MESHOPS_API FlipEffect flip(Connectivity& mesh, Edge e, Keep keep = Keep::simplicial);

/// Undoes a flip: rotates the edge clockwise. Restores every record if the mesh is as flip() left it.
/// Requires: flip_blocker(mesh, effect.edge, Keep::manifold) is empty.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Cost:     constant.
MESHOPS_API void undo(Connectivity& mesh, const FlipEffect& effect);

}  // namespace meshops
