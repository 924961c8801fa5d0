// What: hooks: functions that a split or a collapse calls as soon as the elements are linked, to place the new or
//       surviving vertex and to fill in properties.
// Law:  the links do not depend on the hook. A hook that throws leaves the mesh as it was before the operator, in every
//       record and property, except for what the hook wrote to old elements. Elements that the hook added stay; those
//       of a split are then marked deleted instead of removed, or, without status of every kind, the split stays.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"

namespace meshops {

/// Mesh type of OpenMesh that keeps a point of floating-point coordinates for each vertex.
template <typename Mesh>
concept HasPoints = std::derived_from<Mesh, Connectivity> && requires(Mesh& mesh, Vertex v, typename Mesh::Point p) {
  p = mesh.point(v);
  mesh.set_point(v, p);
  requires std::floating_point<std::remove_cvref_t<decltype(p[0])>>;
};

/// Callable as hook(mesh, effect) with the effect of split_edge(), split_face(), split_vertex() or collapse(). A hook
/// may write points and properties of any element. It must not change links: if it does and then throws, the split
/// or collapse may stay.
template <typename Hook, typename Mesh, typename Effect>
concept SplitHook = std::derived_from<Mesh, Connectivity> && std::invocable<Hook&, Mesh&, const Effect&>;

/// Puts the new vertex in the middle of the edge, at the centroid of the triangle, or on the vertex that was split, and
/// the survivor of a collapse in the middle of the edge. Splits of a mesh with points use PlaceVertex when no hook is
/// given; collapse() does not.
struct PlaceVertex {
  template <HasPoints Mesh>
  void operator()(Mesh& mesh, const SplitEdgeEffect& effect) const {
    set_middle(mesh, effect.added.vertex, mesh.from_vertex_handle(effect.line), mesh.to_vertex_handle(effect.halfedge));
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
  template <HasPoints Mesh>
  void operator()(Mesh& mesh, const WeldEffect& effect) const {
    set_middle(mesh, effect.survivor, effect.survivor, effect.removed.vertex);
  }

 private:
  template <typename Mesh>
  static void set_middle(Mesh& mesh, Vertex v, Vertex a, Vertex b) {
    // Halves before adding, because the sum may overflow.
    const auto half = static_cast<Scalar<Mesh>>(0.5);
    typename Mesh::Point middle = mesh.point(a) * half;
    middle += mesh.point(b) * half;
    mesh.set_point(v, middle);
  }
  template <typename Mesh>
  using Scalar = std::remove_cvref_t<decltype(std::declval<typename Mesh::Point&>()[0])>;
};

namespace detail {

/// Copies all properties, including status, of an edge and its halfedges: from → heir, and their opposites likewise.
MESHOPS_API void copy_edge_properties(Connectivity& mesh, Halfedge from, Halfedge heir);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitEdgeEffect& effect);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitFaceEffect& effect);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitVertexEffect& effect);

/// Undoes a split whose hook threw, and removes the elements that the split added; the Law above names the exceptions.
MESHOPS_API void take_back(Connectivity& mesh, const SplitEffect& effect);
/// Undoes a collapse whose hook threw.
MESHOPS_API void take_back(Connectivity& mesh, const WeldEffect& effect);

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

/// Copies all properties, OpenMesh's own and added ones, from old elements to the new elements made of them:
/// - split_edge(): from the edge and its halfedges to the new half of the edge, and to each new face from the face from
///   which it was cut;
/// - split_face(): from the face to the new faces;
/// - split_vertex(): from the old vertex to the new one; where an edge opens to two, both have the old properties.
/// Other new elements have no old one and get default values: for example edges across a face, and the faces of
/// split_vertex(). In a mesh with points, the new vertex is also placed (PlaceVertex). Not for collapse().
struct CarryOver {
  template <typename Mesh, std::derived_from<SplitEffect> Effect>
  requires std::derived_from<Mesh, Connectivity>
  void operator()(Mesh& mesh, const Effect& effect) const {
    detail::carry_over(mesh, effect);
    if constexpr (HasPoints<Mesh>) PlaceVertex()(mesh, effect);
  }
};

}  // namespace meshops
