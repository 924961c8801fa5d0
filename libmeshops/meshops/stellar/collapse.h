// What:   the operator that merges one vertex of an edge into the other.
// Law:    collapse(h) equals flips of edges at the start of h, until only h and its two neighbors are left there, and
//         then a weld_face() of that vertex.
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
/// not exist or is deleted; a face at its edge is not a triangle; its edge is an inner one between boundary vertices,
/// which would become a pinch; a second edge joins its ends and would become a loop; nothing but an edge would be left
/// of the component; the start of h has several fans (core/fans.h); with Keep::simplicial, the link condition fails:
/// the ends have a common neighbor other than the apexes, or both have three edges on a tetrahedron.
MESHOPS_API std::optional<Blocker> collapse_blocker(const Connectivity& mesh, Halfedge h, Keep keep = Keep::simplicial);

/// Merges the vertex v of h = v→w into w, which takes over the fan of v; the triangles at h close.
/// Effect:      v, the edge of h, the edges from v to the apexes, and the faces at h are marked deleted. Every
///              other halfedge from or to v becomes one from or to w. The edges from w to the apexes survive, except
///              if v is an inner vertex with only two edges: both apexes are one vertex, two edges join it to w, and
///              only the one on the right of h survives.
/// Requires:    collapse_blocker() is empty; the mesh has status of every kind.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the elements marked deleted.
/// Inverse:     split_vertex(left, right) of the returned effect, up to handles; undo(), exactly.
/// Δ:           V −1, E −3, F −2; along a boundary edge V −1, E −2, F −1; the topology stays.
/// Cost:        the degree of v; Keep::simplicial: for each edge of v, up to twice the degree of w.
MESHOPS_API WeldEffect collapse(Connectivity& mesh, Halfedge h, Keep keep = Keep::simplicial);

/// Collapses h, or returns why it cannot be collapsed: collapse_blocker() and collapse() with one test of the links.
MESHOPS_API std::variant<WeldEffect, Blocker> try_collapse(Connectivity& mesh, Halfedge h,
                                                           Keep keep = Keep::simplicial);

/// Collapses h and then calls hook(mesh, effect) (split_hooks.h): PlaceVertex, Interpolate, or any callable, which may
/// place the surviving vertex and give it properties. The removed elements still have theirs.
/// Throws: ContractViolation, and what the hook throws; the mesh is then as before, except for what the hook wrote.
template <typename Mesh, SplitHook<Mesh, WeldEffect> Hook>
WeldEffect collapse(Mesh& mesh, Halfedge h, Hook hook, Keep keep = Keep::simplicial) {
  return detail::with_hook(mesh, collapse(static_cast<Connectivity&>(mesh), h, keep), hook);
}

}  // namespace meshops
