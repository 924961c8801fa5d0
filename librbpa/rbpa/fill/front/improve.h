// What:   improves a triangulation: moves inner points and flips inner edges.
// Law:    every triangle stays counter-clockwise, which is decided exactly, and the boundary stays; at the end the
//         triangulation is the constrained Delaunay triangulation of its points, except for points on one circle.
// Cost:   linear in practice; flips are quadratic at worst.
// Source: Lawson, Software for C1 surface interpolation (1977); Freitag, Ollivier-Gooch, Tetrahedral mesh improvement
//         using swapping and smoothing (1997).
#pragma once

#include <cstddef>

#include "rbpa/base/mesh.h"
#include "rbpa/fill/front/size_field.h"

namespace rbpa {

/// Improves a mesh. Vertices from number `fixed` on are inner ones, and may move. Calls `checkpoint` repeatedly;
/// it may throw.
/// Requires: triangles that are counter-clockwise and do not overlap, z = 0.
void improve(Mesh& mesh, std::size_t fixed, const SizeField& field, const Checkpoint& checkpoint);

}  // namespace rbpa
