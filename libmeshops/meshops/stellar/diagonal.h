// What:   the operators that cut a face in two along a diagonal, and that merge two faces by removing a common edge.
// Law:    remove_diagonal(insert_diagonal(from, to).diagonal) restores every live record (core/validate.h). The
//         topology stays.
// Source: Mäntylä, An introduction to solid modeling (1988): make edge and face, kill edge and face.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"
#include "meshops/stellar/keep.h"

namespace meshops {

struct InsertDiagonalEffect {
  Halfedge diagonal{};  ///< halfedge of the new edge, with the new face on its left
  Face face{};          ///< the new face
  constexpr Delta delta() const { return {.edges = 1, .faces = 1}; }
};

struct RemoveDiagonalEffect {
  Edge edge{};            ///< the edge of h, marked deleted
  Face face{};            ///< the face of h, marked deleted
  Face survivor{};        ///< the face on the other side of the edge, which now has the sides of both faces
  Halfedge from{}, to{};  ///< insert_diagonal(from, to) is the inverse
  constexpr Delta delta() const { return {.edges = -1, .faces = -1}; }
};

/// Returns why no diagonal can join the starts of `from` and `to`, or nothing when one can. The reasons: a halfedge
/// does not exist or is deleted; the two are not different sides of one face; the two corners are neighbors along the
/// face, so that a face of two sides would be left, or are one vertex, so that the diagonal would be a loop; or, with
/// Keep::simplicial, an edge joins the corners already, or the diagonal would cut a quadrangle that touches itself into
/// two triangles with the same corners.
/// Cost: constant; with Keep::simplicial, the lesser degree of the two corners.
MESHOPS_API std::optional<Blocker> insert_diagonal_blocker(const Connectivity& mesh, Halfedge from, Halfedge to,
                                                           Keep keep = Keep::simplicial);

/// Cuts the face with the sides `from` and `to` along a new edge between the starts of these sides.
/// Effect:      the part with mesh.halfedge_handle(face) keeps the handle of the face; the other part is a new face.
///              New elements have default values of all properties.
/// Requires:    insert_diagonal_blocker() with the same `keep` is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: nothing.
/// Inverse:     remove_diagonal(), exactly.
/// Δ:           E +1, F +1. The topology does not change.
/// Cost:        the number of sides of the face; with Keep::simplicial, also the lesser degree of the two corners.
MESHOPS_API InsertDiagonalEffect insert_diagonal(Connectivity& mesh, Halfedge from, Halfedge to,
                                                 Keep keep = Keep::simplicial);

/// Returns why the edge of h cannot be removed, or nothing when it can. The reasons: the mesh lacks status of some
/// kind, h does not exist or is deleted, the edge is on the boundary, or one face lies on both sides of the edge.
/// Cost: constant.
MESHOPS_API std::optional<Blocker> remove_diagonal_blocker(const Connectivity& mesh, Halfedge h);

/// Removes the edge of h. The edge and the face of h are marked deleted; the face on the other side of the edge gets
/// the sides of both faces. Two faces with several common edges become one face that touches itself.
/// Requires:    remove_diagonal_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the elements marked deleted.
/// Inverse:     insert_diagonal(from, to) of the returned effect, up to handles.
/// Δ:           E −1, F −1. The topology does not change.
/// Cost:        the number of sides of the face of h.
MESHOPS_API RemoveDiagonalEffect remove_diagonal(Connectivity& mesh, Halfedge h);

}  // namespace meshops
