// What: what is done to a new vertex, edge or face as soon as a split has linked it: where the vertex lies, and which
//       properties the elements take over. The links themselves do not depend on it.
// Law:  a hook that throws leaves the mesh as it was before the split, in every record and property.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/effect.h"

namespace meshops {

/// Any mesh type of OpenMesh that keeps a point for each vertex, of two or more floating-point coordinates.
template <typename Mesh>
concept HasPoints = std::derived_from<Mesh, Connectivity> && requires(Mesh& mesh, Vertex v, typename Mesh::Point p) {
  p = mesh.point(v);
  mesh.set_point(v, p);
  requires std::floating_point<std::remove_cvref_t<decltype(p[0])>>;
};

/// Called as hook(mesh, effect) with the effect of split_edge(), split_face() or split_vertex(). It may write points and
/// properties, of any element; if it throws, only what it wrote to old elements stays. It must not change links.
template <typename Hook, typename Mesh, typename Effect>
concept SplitHook = std::derived_from<Mesh, Connectivity> && std::invocable<Hook&, Mesh&, const Effect&>;

/// Puts the new vertex in the middle of the edge, at the centroid of the triangle, on the vertex that was split. It is
/// what splits of a mesh with points do when no hook is given.
struct PlaceVertex {
  template <HasPoints Mesh>
  void operator()(Mesh& mesh, const SplitEdgeEffect& effect) const {
    // Halved first and then added, because the sum may overflow.
    const auto half = static_cast<Scalar<Mesh>>(0.5);
    typename Mesh::Point middle = mesh.point(mesh.from_vertex_handle(effect.line)) * half;
    middle += mesh.point(mesh.to_vertex_handle(effect.halfedge)) * half;
    mesh.set_point(effect.added.vertex, middle);
  }
  template <HasPoints Mesh>
  void operator()(Mesh& mesh, const SplitFaceEffect& effect) const {
    const Halfedge vw = effect.halfedge;
    const Halfedge vc = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(vw));
    const Halfedge vd = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(vc));
    const auto third = static_cast<Scalar<Mesh>>(1) / 3;
    typename Mesh::Point centroid = mesh.point(mesh.to_vertex_handle(vw)) * third;
    centroid += mesh.point(mesh.to_vertex_handle(vc)) * third;
    centroid += mesh.point(mesh.to_vertex_handle(vd)) * third;
    mesh.set_point(effect.added.vertex, centroid);
  }
  template <HasPoints Mesh>
  void operator()(Mesh& mesh, const SplitVertexEffect& effect) const {
    mesh.set_point(effect.added.vertex, mesh.point(mesh.to_vertex_handle(effect.halfedge)));
  }

 private:
  template <typename Mesh>
  using Scalar = std::remove_cvref_t<decltype(std::declval<typename Mesh::Point&>()[0])>;
};

namespace detail {

/// Copies all properties, status too, of an edge and its halfedges: from → heir, their opposites likewise.
MESHOPS_API void copy_edge_properties(Connectivity& mesh, Halfedge from, Halfedge heir);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitEdgeEffect& effect);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitFaceEffect& effect);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitVertexEffect& effect);

/// Undoes a split from whose hook an exception came; the elements that it added are gone.
MESHOPS_API void take_back(Connectivity& mesh, const SplitEffect& effect);

template <typename Mesh, typename Effect, typename Hook>
Effect with_hook(Mesh& mesh, const Effect& effect, Hook& hook) {
  try {
    hook(mesh, effect);
  } catch (...) {
    take_back(mesh, effect);
    throw;
  }
  return effect;
}

}  // namespace detail

/// Copies all properties of the mesh, those of OpenMesh and those that were added, to what came out of something:
/// - split_edge(): the new half of the edge gets those of the edge and its halfedges; each new face those of the face it
///   was cut from;
/// - split_face(): the new faces get those of the face;
/// - split_vertex(): the new vertex gets those of the old one; each edge that opened, as two, is twice what it was.
/// Edges across a face, and the faces of split_vertex(), were nothing before and have default values. A mesh with points
/// gets the new vertex placed as well (PlaceVertex).
struct CarryOver {
  template <typename Mesh, std::derived_from<SplitEffect> Effect>
  requires std::derived_from<Mesh, Connectivity>
  void operator()(Mesh& mesh, const Effect& effect) const {
    detail::carry_over(mesh, effect);
    if constexpr (HasPoints<Mesh>) PlaceVertex()(mesh, effect);
  }
};

}  // namespace meshops
