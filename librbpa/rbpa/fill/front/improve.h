// What:   improves a triangulation: moves inner points and flips inner edges.
// Law:    every triangle stays counter-clockwise, which is decided exactly, and the boundary does not change. The
//         result is a constrained Delaunay triangulation of its points, unique up to points on one circle.
// Cost:   linear in practice; flips are quadratic at worst.
// Source: Lawson, Software for C1 surface interpolation (1977); Freitag, Ollivier-Gooch, Tetrahedral mesh improvement
//         using swapping and smoothing (1997).
#pragma once

#include <cstddef>

#include "rbpa/base/mesh.h"
#include "rbpa/fill/front/size_field.h"

namespace rbpa {

/// Improves a mesh by six rounds of moves and flips. Moves only vertices that have a number of at least `fixed` and are
/// not on the boundary. Calls `checkpoint` repeatedly.
/// Requires: triangles that are counter-clockwise and do not overlap, z = 0; `checkpoint` is not empty.
/// Throws:   any exception of `checkpoint`.
void improve(Mesh& mesh, std::size_t fixed, const SizeField& field, const Checkpoint& checkpoint);

}  // namespace rbpa
