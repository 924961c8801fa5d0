// What:   the stellar operator that removes a vertex from a triangle; the inverse of split_face().
// Law:    split_face(weld_face(v).face) restores the mesh up to handles; undo() restores all live records.
// Source: Alexander, The combinatorial theory of complexes (1930); Lewiner et al., section on stellar operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/keep.h"

namespace meshops {

struct WeldFaceEffect : WeldEffect {
  Face face{};  ///< the triangle that replaces the three triangles
};

/// Returns why the vertex cannot be welded into one face, or nothing when it can. The reasons: the mesh lacks status of
/// some kind; the vertex does not exist or is deleted, is isolated or on the boundary, or does not have three edges; a
/// face at the vertex is not a triangle; or, with Keep::simplicial, a triangle with the three neighbors of the vertex
/// as corners exists already.
/// Cost: constant; with Keep::simplicial, the degree of the end of mesh.halfedge_handle(v).
MESHOPS_API std::optional<Blocker> weld_face_blocker(const Connectivity& mesh, Vertex v, Keep keep = Keep::simplicial);

/// Removes an inner vertex of degree three; its three triangles become one.
/// Effect:      the vertex, its edges, and the two faces at the edge of mesh.halfedge_handle(v) are marked deleted;
///              the third face becomes the triangle.
/// Requires:    weld_face_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the elements marked deleted.
/// Inverse:     split_face() of `face`, up to handles; undo(), exactly.
/// Δ:           V −1, E −3, F −2. The topology does not change.
/// Cost:        the cost of weld_face_blocker().
MESHOPS_API WeldFaceEffect weld_face(Connectivity& mesh, Vertex v, Keep keep = Keep::simplicial);

}  // namespace meshops
