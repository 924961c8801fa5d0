// What:   the effects that splits, welds and collapses return: the elements that were added or removed.
// Law:    delta() is exact for every application, on every sound mesh; χ, curves, components and genus never change.
// Source: Lewiner, Lopes, Medeiros, Tavares, Velho, Topological mesh operators (CAGD 27, 2010).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"

namespace meshops {

/// The elements that a split adds or a weld removes: a vertex with three edges and two faces, or, on a boundary edge,
/// with two edges and one face.
struct StarElements {
  Vertex vertex{};
  std::array<Edge, 3> edge = {Edge(), Edge(), Edge()};  ///< the edge of the effect's `halfedge`, then those beside it
  std::array<Face, 2> face = {Face(), Face()};          ///< on the left and on the right of the effect's `halfedge`
  bool at_boundary = false;  ///< whether there are two edges and one face: the last of each array is then invalid

  std::span<const Edge> edges() const { return std::span(edge).first(at_boundary ? 2 : 3); }
  std::span<const Face> faces() const { return std::span(face).first(at_boundary ? 1 : 2); }
  /// Returns the change of the counts when these elements are added.
  Delta sum() const {
    return at_boundary ? Delta{.vertices = 1, .edges = 2, .faces = 1} : Delta{.vertices = 1, .edges = 3, .faces = 2};
  }
};

/// Effect of split_edge(), split_face() and split_vertex().
struct SplitEffect {
  StarElements added;
  Halfedge halfedge{};  ///< from the new vertex to an old one: collapse() of this halfedge is the inverse
  Delta delta() const { return added.sum(); }
};

struct SplitEdgeEffect : SplitEffect {
  Halfedge line{};  ///< toward the new vertex, on the half of the edge that keeps its handle
};
struct SplitFaceEffect : SplitEffect {
  Face face{};  ///< the face that was split, now one of three
};
struct SplitVertexEffect : SplitEffect {};

/// Effect of collapse() and remove_vertex(), and part of the effects of weld_edge() and weld_face().
struct WeldEffect {
  StarElements removed;  ///< marked deleted; their records are left as they were, for undo()
  Vertex survivor{};     ///< the vertex that took over the fan of the removed one
  /// The halfedges from the survivor along the two edges into which pairs of edges merged; absent on a side without a
  /// face. The fan that the survivor took over lies between them, counter-clockwise from left to right:
  /// split_vertex(left, right) is the inverse.
  std::optional<Halfedge> left, right;
  Halfedge halfedge{};  ///< from the removed vertex to the survivor; marked deleted
  std::array<Halfedge, 3> named = {
      Halfedge(), Halfedge(),
      Halfedge()};  ///< for undo(): mesh.halfedge_handle() of the survivor and of the ends of left and right, before
  Delta delta() const { return -removed.sum(); }
};

}  // namespace meshops
