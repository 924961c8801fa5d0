// What:   removes a triangle from a mesh in one step: the inverse of insert_triangle().
// Law:    extract_triangle() leaves the same edges and faces as remove_triangle(), but adds none of the elements that
//         unglue() adds. A corner without other faces stays as an isolated vertex.
// Source: Medeiros, A topological framework for advancing front triangulations (2003).
#pragma once

#include <array>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Sides and corners of a triangle, and the effect of its removal. Side i runs from corner i to corner i + 1, modulo 3.
struct TriangleRim {
  std::array<Halfedge, 3> side = {Halfedge(), Halfedge(), Halfedge()};  ///< the halfedges of the face
  std::array<Vertex, 3> corner = {Vertex(), Vertex(), Vertex()};        ///< the vertices at which the sides start
  std::array<bool, 3> is_glued;                                         ///< whether another face lies beyond side i
  std::array<bool, 3> is_passage;  ///< whether the fan at corner i becomes two when the triangle is removed
};

/// Returns the sides and corners of the triangle `f`. Side 0 is the halfedge of the face.
/// Requires: the mesh is sound; not checked.
/// Throws:   ContractViolation if `f` does not exist, is deleted or is not a triangle.
/// Cost:     constant.
MESHOPS_API TriangleRim rim_of(const Connectivity& mesh, Face f);

/// Marks the triangle as deleted, together with its edges that have no other face. Its other sides become boundary
/// halfedges, and a corner without other faces becomes isolated. Where the fan at corner i becomes two, the fan at side
/// i gets the vertex `second[i]`, and the fan at side i − 1 keeps the corner.
/// Requires: `rim` is rim_of() the triangle in the present mesh; where `rim.is_passage[i]` is true, `second[i]` is an
///           isolated vertex, a different one for each i; the mesh has status of every kind. Not checked.
/// Cost:     constant, plus the degree of each `second[i]`.
MESHOPS_API void extract_triangle(Connectivity& mesh, const TriangleRim& rim, const std::array<Vertex, 3>& second);

}  // namespace meshops
