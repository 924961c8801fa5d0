// What:   the operator that merges the vertex at one end of an edge into the vertex at the other end.
// Law:    let v be the start of h, with three or more edges, and with only triangles around v. If v is inner,
//         collapse(h) equals flips of edges at v until only h and two more edges are left at v, followed by
//         weld_face(v). If the edge of h is on the boundary, collapse(h) equals such flips followed by weld_edge(h).
// Source: Lewiner et al., section on stellar operators; Dey, Edelsbrunner, Guha, Nekhayev, Topology preserving edge
//         contraction (1999) for the link condition.
#pragma once

#include <optional>
#include <variant>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/keep.h"
#include "meshops/stellar/split_hooks.h"

namespace meshops {

/// Returns why h cannot be collapsed, or nothing when it can. The reasons: the mesh lacks status of some kind; h does
/// not exist or is deleted; a face at the edge of h is not a triangle; the edge is an inner edge between boundary
/// vertices, which would become a pinch; a second edge joins the ends of h and would become a loop; only one edge of
/// the component would be left; the start of h has several fans (core/fans.h); or, with Keep::simplicial, the link
/// condition fails: the ends of h have a common neighbor besides the apexes, or h is on a tetrahedron.
/// Cost: the degree of the start; with Keep::simplicial, for each edge of the start up to twice the degree of the end.
MESHOPS_API std::optional<Blocker> collapse_blocker(const Connectivity& mesh, Halfedge h, Keep keep = Keep::simplicial);

/// Merges the start v of h = v→w into w. The vertex w takes over the fan of v and keeps its own properties; the
/// triangles at the edge of h vanish.
/// Effect:      v, the edge of h, the edges from v to the apexes, and the faces at h are marked deleted. Each other
///              halfedge from or to v becomes a halfedge from or to w. The edges from w to the apexes stay, with one
///              exception: if v is inner and has only two edges, both apexes are one vertex, which two edges join to w;
///              only the one on the right of h stays.
/// Requires:    collapse_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the elements marked deleted.
/// Inverse:     split_vertex(left, right) of the returned effect, up to handles; undo(), exactly.
/// Δ:           V −1, E −3, F −2; for a boundary edge V −1, E −2, F −1. The topology does not change.
/// Cost:        the cost of collapse_blocker().
MESHOPS_API WeldEffect collapse(Connectivity& mesh, Halfedge h, Keep keep = Keep::simplicial);

/// Collapses h, or returns why h cannot be collapsed and leaves the mesh unchanged. Tests the link condition once,
/// whereas collapse_blocker() followed by collapse() tests it twice.
MESHOPS_API std::variant<WeldEffect, Blocker> try_collapse(Connectivity& mesh, Halfedge h,
                                                           Keep keep = Keep::simplicial);

/// Collapses h and then calls hook(mesh, effect) (stellar/split_hooks.h): PlaceVertex, Interpolate or another callable,
/// which may place the surviving vertex and set its properties. The removed elements still have theirs.
/// Throws: ContractViolation, and what the hook throws; the mesh is then as before, except as split_hooks.h says.
template <typename Mesh, SplitHook<Mesh, WeldEffect> Hook>
WeldEffect collapse(Mesh& mesh, Halfedge h, Hook hook, Keep keep = Keep::simplicial) {
  return detail::with_hook(mesh, collapse(static_cast<Connectivity&>(mesh), h, keep), hook);
}

}  // namespace meshops
