// What:   what the stellar operators that change counts return.
// Law:    delta() is exact for every application, on every mesh; χ, curves, components and genus never change.
// Source: Lewiner, Lopes, Medeiros, Tavares, Velho, Topological mesh operators (CAGD 27, 2010).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"

namespace meshops {

/// A vertex with three edges and two faces, or on a boundary edge two edges and one face, came or went.
struct StarElements {
  Vertex vertex{};
  std::array<Edge, 3> edge = {Edge(), Edge(), Edge()};  ///< the first is the one that split and weld are along
  std::array<Face, 2> face = {Face(), Face()};
  bool at_boundary = false;  ///< then the last edge and the last face are none

  std::span<const Edge> edges() const { return std::span(edge).first(at_boundary ? 2 : 3); }
  std::span<const Face> faces() const { return std::span(face).first(at_boundary ? 1 : 2); }
  Delta sum() const {
    return at_boundary ? Delta{.vertices = 1, .edges = 2, .faces = 1} : Delta{.vertices = 1, .edges = 3, .faces = 2};
  }
};

/// Of split_edge(), split_face() and split_vertex().
struct SplitEffect {
  StarElements added;
  Halfedge halfedge{};  ///< from the new vertex to the one it was split from: collapse() along it is the inverse
  Delta delta() const { return added.sum(); }
};

struct SplitEdgeEffect : SplitEffect {
  Halfedge line{};  ///< the half that stays, towards the new vertex
};
struct SplitFaceEffect : SplitEffect {
  Face face{};  ///< that was split, and is one of three now
};
struct SplitVertexEffect : SplitEffect {};

/// Of collapse() and remove_vertex(), and part of that of weld_edge() and weld_face().
struct WeldEffect {
  StarElements removed;  ///< marked deleted; their records are left as they were, for undo()
  Vertex survivor{};     ///< the vertex that took over the fan of the removed one
  /// The edges of the survivor that were two each, as its outgoing halfedges; none where there was no face. All that
  /// was taken over lies between them, counter-clockwise from left to right: split_vertex(left, right) is the inverse.
  std::optional<Halfedge> left, right;
  Halfedge halfedge{};  ///< marked deleted: from the removed vertex to the survivor
  std::array<Halfedge, 3> named = {
      Halfedge(), Halfedge(),
      Halfedge()};  ///< for undo(): the halfedges of the survivor and of the ends of left and right
  Delta delta() const { return -removed.sum(); }
};

}  // namespace meshops
