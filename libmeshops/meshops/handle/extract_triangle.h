// What:   removes a triangle from a mesh as one step: the inverse of insert_triangle().
// Law:    leaves the mesh that remove_triangle() leaves, without making and deleting the elements that unglue() would.
// Source: Medeiros, A topological framework for advancing front triangulations (2003).
#pragma once

#include <array>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// What a triangle is to the mesh around it. Side i runs from corner i to corner i + 1.
struct TriangleRim {
  std::array<Halfedge, 3> side = {Halfedge(), Halfedge(), Halfedge()};  ///< the halfedges of the face
  std::array<Vertex, 3> corner = {Vertex(), Vertex(), Vertex()};        ///< the vertices that they start at
  std::array<bool, 3> is_glued;                                         ///< a face lies beyond the side
  std::array<bool, 3> is_passage;  ///< without the triangle the fan at the corner falls in two
};

/// Requires: a triangle of a sound mesh. Throws ContractViolation. Cost: constant.
MESHOPS_API TriangleRim rim_of(const Connectivity& mesh, Face f);

/// Marks the triangle as deleted, and its sides beyond which there is no face. Its other sides are boundary halfedges
/// then. A corner without other faces is isolated then; where a fan falls in two, the one that the boundary enters the
/// corner by, before, gets the vertex `second[i]`.
/// Requires: rim_of() the triangle; isolated vertices for the passages; status of every kind. Not checked.
/// Cost:     constant, plus the degree of each corner that becomes two.
MESHOPS_API void extract_triangle(Connectivity& mesh, const TriangleRim& rim, const std::array<Vertex, 3>& second);

}  // namespace meshops
