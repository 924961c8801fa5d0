// What: hooks: functions that a split or a collapse calls as soon as the elements are linked, to place the new or
//       surviving vertex and to set properties.
// Law:  the links do not depend on the hook. When a hook throws, the mesh is as before the operator, in every record
//       and property, except for values that the hook wrote to old elements. If the hook also added elements, these
//       stay, and those of a split are marked deleted instead of removed; without status, the split stays.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"

namespace meshops {

/// Mesh type of OpenMesh with a point of floating-point coordinates for each vertex.
template <typename Mesh>
concept HasPoints = std::derived_from<Mesh, Connectivity> && requires(Mesh& mesh, Vertex v, typename Mesh::Point p) {
  p = mesh.point(v);
  mesh.set_point(v, p);
  requires std::floating_point<std::remove_cvref_t<decltype(p[0])>>;
};

/// Callable as hook(mesh, effect) with the effect of split_edge(), split_face(), split_vertex() or collapse(). A hook
/// may write points and properties of any element. A hook must not change links: if it does and then throws, the split
/// or collapse may stay.
template <typename Hook, typename Mesh, typename Effect>
concept SplitHook = std::derived_from<Mesh, Connectivity> && std::invocable<Hook&, Mesh&, const Effect&>;

/// Hook that places the new vertex of a split in the middle of the edge, at the centroid of the triangle, or on the
/// vertex that was split, and the survivor of a collapse in the middle of the edge. Without a given hook, splits of a
/// mesh with points use PlaceVertex; collapse() does not.
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
    // Halves before it adds, because the sum may overflow.
    const auto half = static_cast<Scalar<Mesh>>(0.5);
    typename Mesh::Point middle = mesh.point(a) * half;
    middle += mesh.point(b) * half;
    mesh.set_point(v, middle);
  }
  template <typename Mesh>
  using Scalar = std::remove_cvref_t<decltype(std::declval<typename Mesh::Point&>()[0])>;
};

namespace detail {

/// Copies all properties, including status, from the edge and the halfedges of `from` to those of `heir`.
MESHOPS_API void copy_edge_properties(Connectivity& mesh, Halfedge from, Halfedge heir);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitEdgeEffect& effect);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitFaceEffect& effect);
MESHOPS_API void carry_over(Connectivity& mesh, const SplitVertexEffect& effect);

/// Undoes a split whose hook threw, and removes the elements that the split added, except as the Law above says.
MESHOPS_API void take_back(Connectivity& mesh, const SplitEffect& effect);
/// Undoes a collapse whose hook threw. A collapse whose links the hook changed may stay.
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

/// Hook that copies all properties, OpenMesh's own and added ones, from old elements to the new elements made of them:
/// - split_edge(): from the edge and its halfedges to the new half of the edge, and from each face to its new part;
/// - split_face(): from the face to the new faces;
/// - split_vertex(): from the old vertex to the new one, and from an edge that opens to the second of the two edges.
/// Other new elements get default values, for example edges across a face, and the faces of split_vertex(). In a mesh
/// with points, CarryOver also places the new vertex (PlaceVertex). It does not serve collapse().
struct CarryOver {
  template <typename Mesh, std::derived_from<SplitEffect> Effect>
  requires std::derived_from<Mesh, Connectivity>
  void operator()(Mesh& mesh, const Effect& effect) const {
    detail::carry_over(mesh, effect);
    if constexpr (HasPoints<Mesh>) PlaceVertex()(mesh, effect);
  }
};

}  // namespace meshops
