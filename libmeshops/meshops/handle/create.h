// What:   the handle operator that adds a triangle as a new component.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"

namespace meshops {

struct CreateTriangleEffect {
  Face face{};          ///< the new triangle
  Halfedge inner{};     ///< the side of the triangle from its first to its second vertex
  Halfedge boundary{};  ///< the opposite of `inner`, on the new boundary curve
  Delta delta() const { return delta_of_create(); }
};

/// Adds a triangle with three new vertices and three new edges, as a new component. All properties have default values.
/// A default point is unspecified, because OpenMesh's vectors have no default.
/// Δ:        V +3, E +3, F +1, χ +1, curves +1, components +1, genus 0.
/// Inverse:  destroy_triangle() of the face.
/// Cost:     constant.
MESHOPS_API CreateTriangleEffect create_triangle(Connectivity& mesh);

}  // namespace meshops
