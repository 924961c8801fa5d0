// What:   create a triangle and glue up to three of its sides to boundary edges, as one step.
// Law:    leaves the same mesh as create_triangle() followed by a glue() per given side (tested), without making and
//         deleting the elements that the glues would merge. All the ways to attach a triangle to a front are this.
// Source: Medeiros, A topological framework for advancing front triangulations (2003), attach cases.
#pragma once

#include <array>

#include "meshops/core/connectivity.h"

namespace meshops {

/// Where a triangle goes. Side i runs from corner i to corner i + 1.
struct TriangleSides {
  /// A boundary halfedge that becomes this side, or an invalid handle for a new edge.
  std::array<Halfedge, 3> side;
  /// The vertex of a corner between two new sides: an isolated one. Not looked at for other corners.
  std::array<Vertex, 3> corner;
};

struct InsertedTriangle {
  Face face;
  std::array<Halfedge, 3> side;  ///< the halfedges of the face
  int merged = 0;                ///< how many vertices were merged into others
  /// The vertices that lost: isolated now, and of no use to the mesh. The lower handle of a pair survives.
  std::array<Vertex, 3> left_over;
};

/// Where insert_triangle() gets its edge and face elements: one by one from the mesh, or from a supply of the caller's.
struct NewElements {
  Connectivity& mesh;
  Halfedge edge(Vertex from, Vertex to) { return mesh.new_edge(from, to); }
  Face face() { return mesh.new_face(); }
};

namespace detail {

/// Makes every edge of the fan at `from` end at `to` instead. The fan is reached through its boundary halfedge.
inline void move_fan(Connectivity& mesh, Vertex from, Vertex to) {
  const Halfedge first = mesh.halfedge_handle(from);
  Halfedge out = first;
  do {
    const Halfedge in = mesh.opposite_halfedge_handle(out);
    mesh.set_vertex_handle(in, to);
    out = mesh.next_halfedge_handle(in);
  } while (out != first);
}

}  // namespace detail

/// Requires: given sides are distinct boundary halfedges; corners between two new sides are isolated vertices; no two
///           corners become the same vertex. Not checked: this is the inner loop of every advancing front.
/// Cost:     constant, plus the degree of each vertex that is merged into another.
template <typename Elements>
InsertedTriangle insert_triangle(Connectivity& mesh, const TriangleSides& sides, Elements&& elements) {
  InsertedTriangle result;
  std::array<bool, 3> given;
  std::array<Halfedge, 3> before;  // of each given side, its neighbours on the boundary before the change
  std::array<Halfedge, 3> after;
  for (unsigned i = 0; i < 3; ++i) {
    given[i] = sides.side[i].is_valid();
    if (given[i]) {
      before[i] = mesh.prev_halfedge_handle(sides.side[i]);
      after[i] = mesh.next_halfedge_handle(sides.side[i]);
    }
  }

  std::array<Vertex, 3> corner;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned p = (i + 2) % 3;
    if (!given[i] && !given[p]) {
      corner[i] = sides.corner[i];
      continue;
    }
    const Vertex out = given[i] ? mesh.from_vertex_handle(sides.side[i]) : mesh.to_vertex_handle(sides.side[p]);
    const Vertex in = given[p] ? mesh.to_vertex_handle(sides.side[p]) : out;
    if (in == out) {
      corner[i] = in;
      continue;
    }
    corner[i] = in.idx() < out.idx() ? in : out;
    const Vertex loser = in.idx() < out.idx() ? out : in;
    detail::move_fan(mesh, loser, corner[i]);
    mesh.set_isolated(loser);
    result.left_over[static_cast<unsigned>(result.merged++)] = loser;
  }

  result.face = elements.face();
  for (unsigned i = 0; i < 3; ++i) {
    result.side[i] = given[i] ? sides.side[i] : elements.edge(corner[i], corner[(i + 1) % 3]);
    mesh.set_face_handle(result.side[i], result.face);
  }
  mesh.set_halfedge_handle(result.face, result.side[0]);

  for (unsigned i = 0; i < 3; ++i) {
    const unsigned p = (i + 2) % 3;  // side p comes into corner i, side i leaves it
    if (given[p] && after[p] == sides.side[i]) {
      // The two sides were neighbours on the boundary: the corner closes.
      mesh.set_halfedge_handle(corner[i], result.side[i]);
    } else {
      const Halfedge in = given[i] ? before[i] : mesh.opposite_halfedge_handle(result.side[i]);
      const Halfedge out = given[p] ? after[p] : mesh.opposite_halfedge_handle(result.side[p]);
      mesh.set_next_halfedge_handle(in, out);
      mesh.set_halfedge_handle(corner[i], out);
    }
  }
  for (unsigned i = 0; i < 3; ++i) mesh.set_next_halfedge_handle(result.side[i], result.side[(i + 1) % 3]);
  return result;
}

inline InsertedTriangle insert_triangle(Connectivity& mesh, const TriangleSides& sides) {
  return insert_triangle(mesh, sides, NewElements{mesh});
}

}  // namespace meshops
