// What:   the operator that splits one vertex into two, with an edge between them; the inverse of collapse().
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

/// Returns why the vertex cannot be split between `left` and `right`, or nothing when it can. The reasons: both
/// halfedges are left out; one does not exist or is deleted; they leave different vertices; one is left out, but the
/// vertex is inner; the vertex has several fans (core/fans.h) and the boundary passes between the halfedges; or, with
/// Keep::simplicial, two edges would join the new vertex to one other vertex.
/// Cost: at most the cost of split_vertex().
MESHOPS_API std::optional<Blocker> split_vertex_blocker(const Connectivity& mesh, std::optional<Halfedge> left,
                                                        std::optional<Halfedge> right, Keep keep = Keep::simplicial);

/// Splits the vertex w that `left` and `right` leave. A new vertex takes over the edges between the two halfedges,
/// counter-clockwise from left to right. The edges of `left` and `right` each open to a triangle with the new edge;
/// `left` lies on the left of the returned halfedge. Without `right`, the new vertex takes over the edges from `left`
/// to the boundary; without `left`, the edges from the boundary to `right`. In both cases the new edge is on the
/// boundary. If `left` equals `right`, the new vertex takes over all edges of w except that of `left`.
/// Effect:      `left` and `right` still leave w; new edges between the new vertex and the ends of `left` and `right`
///              take their places in the fan of the new vertex. No face loses a side. New elements have default values
///              of all properties. A default point is unspecified, because OpenMesh's vectors have no default; the
///              overloads below place the new vertex.
/// Returns:     the added elements, and the halfedge from the new vertex to w.
/// Requires:    split_vertex_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: nothing.
/// Inverse:     collapse() along the returned halfedge, exactly.
/// Δ:           V +1, E +3, F +2; with one halfedge left out V +1, E +2, F +1. The topology does not change.
/// Cost:        the number of edges that the new vertex takes over; if w is on the boundary, up to the degree of w.
MESHOPS_API SplitVertexEffect split_vertex(Connectivity& mesh, std::optional<Halfedge> left,
                                           std::optional<Halfedge> right, Keep keep = Keep::simplicial);

/// Splits the vertex and then calls hook(mesh, effect) (split_hooks.h): PlaceVertex, CarryOver, or another callable.
/// Throws: ContractViolation, and what the hook throws; the mesh is then as before, except as split_hooks.h says.
template <typename Mesh, SplitHook<Mesh, SplitVertexEffect> Hook>
SplitVertexEffect split_vertex(Mesh& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right, Hook hook,
                               Keep keep = Keep::simplicial) {
  return detail::with_hook(mesh, split_vertex(static_cast<Connectivity&>(mesh), left, right, keep), hook);
}

/// Splits a vertex of a mesh with points, and places the new vertex at the point of the old one.
template <HasPoints Mesh>
SplitVertexEffect split_vertex(Mesh& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right,
                               Keep keep = Keep::simplicial) {
  return split_vertex(mesh, left, right, PlaceVertex(), keep);
}

}  // namespace meshops
