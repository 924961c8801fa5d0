// What:   the handle operator that begins a component: it adds a triangle.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Adds a triangle with three new vertices and three new edges. All properties, points included, have default values.
/// Returns:  the halfedge inside the triangle from the first to the second new vertex; its opposite is on the boundary.
/// Δ:        V +3, E +3, F +1, χ +1, curves +1, components +1, genus 0.
/// Cost:     constant.
MESHOPS_API Halfedge create_triangle(Connectivity& mesh);

}  // namespace meshops
