// What:   a triangulation made better: inner points move, inner edges flip, and edges much too long or too short go.
// Law:    every triangle stays counter-clockwise, which is decided exactly, and the boundary stays; at the end the
//         triangulation is the constrained Delaunay triangulation of its points, but for points on one circle.
// Cost:   linear in practice; flips are quadratic at worst.
// Source: Lawson, Software for C1 surface interpolation (1977); Freitag, Ollivier-Gooch, Tetrahedral mesh improvement
//         using swapping and smoothing (1997).
#pragma once

#include <cstddef>
#include <functional>

#include "rbpa/core/mesh.h"
#include "rbpa/fill/size_field.h"

namespace rbpa {

/// Vertices from number `fixed` on are inner ones, and may move; vertices may come and go: those that go are marked deleted.
/// Requires: the mesh has status of every kind. Calls `ask` now and then, which may throw.
void improve(Mesh& mesh, std::size_t fixed, const SizeField& field, const std::function<void()>& ask);

}  // namespace rbpa
