// What:   removes a triangle from a mesh as one step: the inverse of insert_triangle().
// Law:    leaves the same edges and faces as remove_triangle(), without making and deleting the elements that unglue()
//         would. A corner without other faces stays, as an isolated vertex.
// Source: Medeiros, A topological framework for advancing front triangulations (2003).
#pragma once

#include <array>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Sides and corners of a triangle, and what of the mesh around it stays when it is removed. Side i runs from corner i
/// to corner i + 1, modulo 3.
struct TriangleRim {
  std::array<Halfedge, 3> side = {Halfedge(), Halfedge(), Halfedge()};  ///< the halfedges of the face
  std::array<Vertex, 3> corner = {Vertex(), Vertex(), Vertex()};        ///< the vertices at which the sides start
  std::array<bool, 3> is_glued;                                         ///< another face lies beyond the side
  std::array<bool, 3> is_passage;  ///< without the triangle, the fan at the corner would be two
};

/// Returns the rim of a live triangle of a sound mesh. Throws ContractViolation if `f` is none. Cost: constant.
MESHOPS_API TriangleRim rim_of(const Connectivity& mesh, Face f);

/// Marks the triangle as deleted, together with its edges that have no other face. Its other sides become boundary
/// halfedges, and a corner without other faces becomes isolated. At a corner whose fan becomes two, the fan through
/// which the boundary entered the corner gets the vertex `second[i]`.
/// Requires: `rim` is rim_of() the triangle; `second[i]` is an isolated vertex at each passage; the mesh has status of
///           every kind. Not checked.
/// Cost:     constant, plus the degree of each corner that becomes two vertices.
MESHOPS_API void extract_triangle(Connectivity& mesh, const TriangleRim& rim, const std::array<Vertex, 3>& second);

}  // namespace meshops
