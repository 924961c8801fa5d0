// What:   the stellar operator that puts a vertex on an edge.
// Law:    weld_edge(split_edge(h).halfedge) restores every live record of the mesh.
// Source: Alexander, The combinatorial theory of complexes (1930); Lewiner et al., section on stellar operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/keep.h"
#include "meshops/stellar/split_hooks.h"

namespace meshops {

/// Returns why the edge e, or the edge of h, cannot be split, or nothing when it can. The reasons: the edge does not
/// exist or is deleted, a face at the edge is not a triangle, or, with Keep::simplicial, both triangles have the same
/// apex, to which two edges would join the new vertex. Cost: constant.
MESHOPS_API std::optional<Blocker> split_edge_blocker(const Connectivity& mesh, Halfedge h,
                                                      Keep keep = Keep::simplicial);
MESHOPS_API std::optional<Blocker> split_edge_blocker(const Connectivity& mesh, Edge e, Keep keep = Keep::simplicial);

/// Splits the edge of h = a→b at a new vertex, which edges join to the apex of each triangle at the edge.
/// Effect:      h and its edge keep their handles and become the half from a to the new vertex; the old faces stay on
///              the side of a. The half from the new vertex to b and the faces on the side of b are new. New elements
///              have default values of all properties. A default point is unspecified, because OpenMesh's vectors have
///              no default; the overloads below place the new vertex.
/// Returns:     the added elements, and the halfedge from the new vertex to b.
/// Requires:    split_edge_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: nothing.
/// Inverse:     weld_edge() along the returned halfedge, exactly.
/// Δ:           V +1, E +3, F +2; for a boundary edge V +1, E +2, F +1. The topology does not change.
/// Cost:        constant.
MESHOPS_API SplitEdgeEffect split_edge(Connectivity& mesh, Halfedge h, Keep keep = Keep::simplicial);

/// Splits the edge as split_edge(mesh, mesh.halfedge_handle(e, 0), keep) does.
MESHOPS_API SplitEdgeEffect split_edge(Connectivity& mesh, Edge e, Keep keep = Keep::simplicial);

/// Splits the edge of h, or the edge e, and then calls hook(mesh, effect) (split_hooks.h): PlaceVertex, CarryOver or
/// any callable.
/// Throws: ContractViolation, and what the hook throws; the mesh is then as before, except as split_hooks.h says.
template <typename Mesh, SplitHook<Mesh, SplitEdgeEffect> Hook>
SplitEdgeEffect split_edge(Mesh& mesh, Halfedge h, Hook hook, Keep keep = Keep::simplicial) {
  return detail::with_hook(mesh, split_edge(static_cast<Connectivity&>(mesh), h, keep), hook);
}
template <typename Mesh, SplitHook<Mesh, SplitEdgeEffect> Hook>
SplitEdgeEffect split_edge(Mesh& mesh, Edge e, Hook hook, Keep keep = Keep::simplicial) {
  return detail::with_hook(mesh, split_edge(static_cast<Connectivity&>(mesh), e, keep), hook);
}

/// Splits an edge of a mesh with points, and places the new vertex in the middle of the edge.
template <HasPoints Mesh>
SplitEdgeEffect split_edge(Mesh& mesh, Halfedge h, Keep keep = Keep::simplicial) {
  return split_edge(mesh, h, PlaceVertex(), keep);
}
template <HasPoints Mesh>
SplitEdgeEffect split_edge(Mesh& mesh, Edge e, Keep keep = Keep::simplicial) {
  return split_edge(mesh, e, PlaceVertex(), keep);
}

}  // namespace meshops
