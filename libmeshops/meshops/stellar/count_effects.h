// What:   the effects that splits, welds and collapses return: the elements that the operator added or removed.
// Law:    delta() is exact for every operation on a sound mesh; χ, curves, components and genus never change.
// Source: Lewiner, Lopes, Medeiros, Tavares, Velho, Topological mesh operators (CAGD 27, 2010).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"

namespace meshops {

/// The elements that a split adds or a weld removes: a vertex, three edges and two faces, or, at the boundary, a
/// vertex, two edges and a face.
struct StarElements {
  Vertex vertex{};
  /// The edge of the effect's `halfedge`, then the edges from `vertex` to the apexes on its left and its right. If a
  /// weld removes an inner vertex of two edges, the last is the edge from the survivor to the left apex instead.
  std::array<Edge, 3> edge = {Edge(), Edge(), Edge()};
  std::array<Face, 2> face = {Face(), Face()};  ///< the faces on the left and the right of `halfedge`
  /// Whether one side has no face, so that there are only two edges and one face; the last entries are then invalid.
  bool at_boundary = false;

  std::span<const Edge> edges() const { return std::span(edge).first(at_boundary ? 2 : 3); }
  std::span<const Face> faces() const { return std::span(face).first(at_boundary ? 1 : 2); }
  /// Returns the change of the counts when the elements are added.
  Delta sum() const {
    return at_boundary ? Delta{.vertices = 1, .edges = 2, .faces = 1} : Delta{.vertices = 1, .edges = 3, .faces = 2};
  }
};

/// Effect of split_edge(), split_face() and split_vertex().
struct SplitEffect {
  StarElements added;
  Halfedge halfedge{};  ///< from the new vertex to an old one; collapse() of this halfedge is the inverse
  Delta delta() const { return added.sum(); }
};

struct SplitEdgeEffect : SplitEffect {
  Halfedge line{};  ///< the halfedge that ends at the new vertex, on the half of the edge that keeps its handle
};
struct SplitFaceEffect : SplitEffect {
  Face face{};  ///< the face that was split, now one of three faces
};
struct SplitVertexEffect : SplitEffect {};

/// Effect of collapse() and remove_vertex(), and part of the effects of weld_edge() and weld_face().
struct WeldEffect {
  StarElements removed;  ///< the elements marked deleted; their records stay as they were, for undo()
  Vertex survivor{};     ///< the vertex that took over the fan of the removed vertex
  /// The halfedges from the survivor along the two edges into each of which two edges merged; absent on a side of
  /// `halfedge` without a face. The fan that the survivor took over lies between the two, counter-clockwise from left
  /// to right. split_vertex(left, right) is the inverse.
  std::optional<Halfedge> left, right;
  Halfedge halfedge{};  ///< from the removed vertex to the survivor; marked deleted
  std::array<Halfedge, 3> named = {
      Halfedge(), Halfedge(),
      Halfedge()};  ///< for undo(): the former halfedges of the survivor and of the ends of `left` and `right`
  Delta delta() const { return -removed.sum(); }
};

}  // namespace meshops
