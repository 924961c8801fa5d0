// What:   the operator that makes two vertices of one, with an edge between them; the inverse of collapse().
// Law:    collapse(split_vertex(left, right).halfedge) restores every live record of the mesh.
// Source: Lewiner, Lopes, Medeiros, Tavares, Velho, Topological mesh operators (2010), section on stellar operators;
//         Hoppe, Progressive meshes (1996).
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/keep.h"
#include "meshops/stellar/split_hooks.h"

namespace meshops {

/// Returns why the vertex cannot be split between these halfedges, or nothing when it can. The reasons: both are left
/// out; one does not exist or is deleted; they leave different vertices; one is left out at an inner vertex; the vertex
/// has several fans (core/fans.h) and the boundary passes between the halfedges; with Keep::simplicial, two edges would
/// join the new vertex to one other vertex.
/// Cost: at most that of split_vertex().
MESHOPS_API std::optional<Blocker> split_vertex_blocker(const Connectivity& mesh, std::optional<Halfedge> left,
                                                        std::optional<Halfedge> right, Keep keep = Keep::simplicial);

/// Splits the vertex w that `left` and `right` leave: a new vertex takes over the edges between the two halfedges,
/// counter-clockwise from left to right. Both edges open to a triangle with the new edge; `left` lies on the left of
/// the returned halfedge. Without `right`, the new vertex takes over the edges from `left` to the boundary; without
/// `left`, those from the boundary to `right`; in both cases the new edge is on the boundary. With equal halfedges, the
/// new vertex takes over all edges of w but that of these halfedges.
/// Effect:      `left` and `right` still leave w; on the side of the new vertex, new edges to the same ends take their
///              places. No face loses a side. New elements have default values of all properties. A default point is
///              unspecified, because OpenMesh's vectors have no default: see the overloads below.
/// Returns:     the added elements, and the halfedge from the new vertex to w.
/// Requires:    split_vertex_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: nothing.
/// Inverse:     collapse() along the returned halfedge, exactly.
/// Δ:           V +1, E +3, F +2; with one halfedge left out V +1, E +2, F +1; the topology stays.
/// Cost:        the number of edges taken over; where w is on the boundary, up to the degree of w.
MESHOPS_API SplitVertexEffect split_vertex(Connectivity& mesh, std::optional<Halfedge> left,
                                           std::optional<Halfedge> right, Keep keep = Keep::simplicial);

/// Splits the vertex and then calls hook(mesh, effect): PlaceVertex, CarryOver, or any callable (split_hooks.h).
/// Throws: ContractViolation, and what the hook throws; the mesh is then as before, except as split_hooks.h says.
template <typename Mesh, SplitHook<Mesh, SplitVertexEffect> Hook>
SplitVertexEffect split_vertex(Mesh& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right, Hook hook,
                               Keep keep = Keep::simplicial) {
  return detail::with_hook(mesh, split_vertex(static_cast<Connectivity&>(mesh), left, right, keep), hook);
}

/// Splits a vertex of a mesh with points: the new vertex lies at the point of the old one.
template <HasPoints Mesh>
SplitVertexEffect split_vertex(Mesh& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right,
                               Keep keep = Keep::simplicial) {
  return split_vertex(mesh, left, right, PlaceVertex(), keep);
}

}  // namespace meshops
