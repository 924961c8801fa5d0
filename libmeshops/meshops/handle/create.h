// What:   the handle operator that begins a component: it adds a triangle.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"

namespace meshops {

struct CreateTriangleEffect {
  Face face{};
  Halfedge inner{};     ///< the side inside the triangle from the first to the second new vertex
  Halfedge boundary{};  ///< the opposite of `inner`, on the new boundary curve
  Delta delta() const { return delta_of_create(); }
};

/// Adds a triangle with three new vertices and three new edges. All properties, points included, have default values.
/// Δ:        V +3, E +3, F +1, χ +1, curves +1, components +1, genus 0.
/// Inverse:  destroy_triangle().
/// Cost:     constant.
MESHOPS_API CreateTriangleEffect create_triangle(Connectivity& mesh);

}  // namespace meshops
