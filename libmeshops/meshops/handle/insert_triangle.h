// What:   adds a triangle and glues up to three of its sides to boundary edges, in one step.
// Law:    the live mesh is the same, up to handles, as after create_triangle() and then a glue() for each given side,
//         except for merged vertices: a vertex that is merged into another stays, isolated and not marked deleted. A
//         front attaches every triangle in this way.
// Source: Medeiros, A topological framework for advancing front triangulations (2003), attach cases.
#pragma once

#include <array>

#include "meshops/core/connectivity.h"
#include "meshops/handle/fan.h"

namespace meshops {

/// Place of a triangle in a mesh. Side i runs from corner i to corner i + 1, modulo 3.
struct TriangleSides {
  /// For each side, the boundary halfedge that becomes the side, or an invalid handle for a new edge.
  std::array<Halfedge, 3> side = {Halfedge(), Halfedge(), Halfedge()};
  /// For each corner between two new sides, an isolated vertex. The entries of other corners are not read.
  std::array<Vertex, 3> corner = {Vertex(), Vertex(), Vertex()};
};

/// The elements that insert_triangle() made and merged.
struct InsertedTriangle {
  Face face{};
  /// The sides of the face, numbered as in TriangleSides. Side 0 is the halfedge of the face.
  std::array<Halfedge, 3> side = {Halfedge(), Halfedge(), Halfedge()};
  int merged = 0;  ///< number of vertices that were merged into others
  /// In the first `merged` entries: the merged vertices. They are isolated, but not marked deleted.
  std::array<Vertex, 3> left_over = {Vertex(), Vertex(), Vertex()};
};

/// Source of new edges and faces for insert_triangle(): each call adds one to the mesh. A caller may pass another type
/// with the same two functions, where edge() returns the halfedge `from` → `to`.
struct NewElements {
  Connectivity& mesh;
  Halfedge edge(Vertex from, Vertex to) { return mesh.new_edge(from, to); }
  Face face() { return mesh.new_face(); }
};

namespace detail {

/// Inserts a triangle. `given` tells at compile time which sides are given: bit i is set if side i is given.
template <unsigned given, typename Elements>
InsertedTriangle insert_triangle_on(Connectivity& mesh, const TriangleSides& sides, Elements& elements) {
  constexpr auto is_given = [](unsigned i) { return (given >> i & 1u) != 0; };
  constexpr auto previous = [](unsigned i) { return (i + 2) % 3; };
  InsertedTriangle result;
  std::array<Halfedge, 3> before;  // for each given side, the boundary halfedge before it; `after`: the one after it
  std::array<Halfedge, 3> after;
  std::array<Vertex, 3> corner;
  const auto for_each = [](auto visit) {
    visit(std::integral_constant<unsigned, 0>());
    visit(std::integral_constant<unsigned, 1>());
    visit(std::integral_constant<unsigned, 2>());
  };

  for_each([&](auto i) {
    if constexpr (is_given(i)) {
      before[i] = mesh.prev_halfedge_handle(sides.side[i]);
      after[i] = mesh.next_halfedge_handle(sides.side[i]);
    }
  });
  for_each([&](auto i) {
    constexpr unsigned p = previous(i);
    if constexpr (!is_given(i) && !is_given(p)) {
      corner[i] = sides.corner[i];
    } else if constexpr (is_given(i) != is_given(p)) {
      corner[i] = is_given(i) ? mesh.from_vertex_handle(sides.side[i]) : mesh.to_vertex_handle(sides.side[p]);
    } else {
      const Vertex out = mesh.from_vertex_handle(sides.side[i]), in = mesh.to_vertex_handle(sides.side[p]);
      corner[i] = in.idx() < out.idx() ? in : out;
      if (in != out) {
        const Vertex loser = in.idx() < out.idx() ? out : in;
        move_fan(mesh, mesh.halfedge_handle(loser), corner[i]);
        mesh.set_isolated(loser);
        result.left_over[static_cast<unsigned>(result.merged++)] = loser;
      }
    }
  });

  result.face = elements.face();
  for_each([&](auto i) {
    if constexpr (is_given(i))
      result.side[i] = sides.side[i];
    else
      result.side[i] = elements.edge(corner[i], corner[(i + 1) % 3]);
  });
  for_each([&](auto i) { mesh.set_face_handle(result.side[i], result.face); });
  mesh.set_halfedge_handle(result.face, result.side[0]);

  // The boundary passes corner i unless sides i − 1 and i were neighbors on it: then the corner becomes inner.
  for_each([&](auto i) {
    constexpr unsigned p = previous(i);  // side p ends at corner i, and side i starts there
    Halfedge in, out;
    if constexpr (is_given(i))
      in = before[i];
    else
      in = mesh.opposite_halfedge_handle(result.side[i]);
    if constexpr (is_given(p))
      out = after[p];
    else
      out = mesh.opposite_halfedge_handle(result.side[p]);
    if (is_given(i) && is_given(p) && out == sides.side[i]) {
      mesh.set_halfedge_handle(corner[i], result.side[i]);
    } else {
      mesh.set_next_halfedge_handle(in, out);
      mesh.set_halfedge_handle(corner[i], out);
    }
  });
  for_each([&](auto i) { mesh.set_next_halfedge_handle(result.side[i], result.side[(i + 1) % 3]); });
  return result;
}

}  // namespace detail

/// Inserts a triangle at `sides`. Its face, and an edge for each side that is not given, come from `elements`. If two
/// given sides meet at a corner but end at two vertices, the vertex of the higher handle is merged into the other.
/// Requires: the mesh is sound; given sides are distinct boundary halfedges; corners between two new sides are isolated
///           vertices; no two corners become the same vertex; no edge joins two vertices that merge. Not checked: this
///           is the inner loop of every advancing front.
/// Cost:     constant, plus the degree of each vertex that is merged into another.
template <typename Elements>
InsertedTriangle insert_triangle(Connectivity& mesh, const TriangleSides& sides, Elements&& elements) {
  const unsigned given = static_cast<unsigned>(sides.side[0].is_valid()) |
                         static_cast<unsigned>(sides.side[1].is_valid()) << 1 |
                         static_cast<unsigned>(sides.side[2].is_valid()) << 2;
  switch (given) {
    case 0:
      return detail::insert_triangle_on<0>(mesh, sides, elements);
    case 1:
      return detail::insert_triangle_on<1>(mesh, sides, elements);
    case 2:
      return detail::insert_triangle_on<2>(mesh, sides, elements);
    case 3:
      return detail::insert_triangle_on<3>(mesh, sides, elements);
    case 4:
      return detail::insert_triangle_on<4>(mesh, sides, elements);
    case 5:
      return detail::insert_triangle_on<5>(mesh, sides, elements);
    case 6:
      return detail::insert_triangle_on<6>(mesh, sides, elements);
    default:
      return detail::insert_triangle_on<7>(mesh, sides, elements);
  }
}

/// Inserts a triangle at `sides`, with new edges and a new face of the mesh (NewElements).
inline InsertedTriangle insert_triangle(Connectivity& mesh, const TriangleSides& sides) {
  return insert_triangle(mesh, sides, NewElements{mesh});
}

}  // namespace meshops
