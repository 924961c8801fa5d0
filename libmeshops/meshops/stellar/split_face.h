// What:   the stellar operator that puts a vertex into a triangle.
// Law:    weld_face(split_face(f).added.vertex) restores every live record of the mesh.
// Source: Alexander, The combinatorial theory of complexes (1930); Lewiner et al., section on stellar operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/split_hooks.h"

namespace meshops {

/// Returns why the face cannot be split, or nothing when it can. The reasons: the face does not exist or is deleted, or
/// it is not a triangle. A split of a face keeps every simplicial mesh simplicial. Cost: constant.
MESHOPS_API std::optional<Blocker> split_face_blocker(const Connectivity& mesh, Face f);

/// Puts a new vertex into a triangle, and joins the vertex to the three corners by edges.
/// Effect:      let mesh.halfedge_handle(f) leave the corner w. The old face stays at the side that does not touch w;
///              the two faces at the new edge to w are new. New elements have default values of all properties. A
///              default point is unspecified, because OpenMesh's vectors have no default; the overloads below place the
///              new vertex.
/// Returns:     the added elements, and the halfedge from the new vertex to w.
/// Requires:    split_face_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: nothing.
/// Inverse:     weld_face() of the new vertex, exactly.
/// Δ:           V +1, E +3, F +2. The topology does not change.
/// Cost:        constant.
MESHOPS_API SplitFaceEffect split_face(Connectivity& mesh, Face f);

/// Splits the face and then calls hook(mesh, effect) (split_hooks.h): PlaceVertex, CarryOver, or another callable.
/// Throws: ContractViolation, and what the hook throws; the mesh is then as before, except as split_hooks.h says.
template <typename Mesh, SplitHook<Mesh, SplitFaceEffect> Hook>
SplitFaceEffect split_face(Mesh& mesh, Face f, Hook hook) {
  return detail::with_hook(mesh, split_face(static_cast<Connectivity&>(mesh), f), hook);
}

/// Splits a face of a mesh with points, and places the new vertex at the centroid of the triangle.
template <HasPoints Mesh>
SplitFaceEffect split_face(Mesh& mesh, Face f) {
  return split_face(mesh, f, PlaceVertex());
}

}  // namespace meshops
