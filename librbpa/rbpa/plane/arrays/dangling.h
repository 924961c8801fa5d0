// What:   the edges of the alpha complex that are in no triangle, from the Delaunay triangulation.
// Source: Edelsbrunner, Kirkpatrick, Seidel (1983); an edge is in the complex when a triangle at the edge is, or when
//         its diametral circle is empty and of a radius ≤ alpha.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/plane/alpha_complex.h"

namespace rbpa {

/// Returns the edges of the alpha complex that are in no triangle of the complex, in lexicographic order.
/// Requires: `delaunay` is alpha_complex(points, infinity, {.neighbors = true}); 0 < alpha ≤ infinity.
/// Cost:     linear; for points on one line, that of a sort.
std::vector<std::array<std::uint32_t, 2>> dangling_edges(std::span<const Point> points, double alpha,
                                                         const AlphaComplex& delaunay);

/// Removes the triangles of circumradius > alpha, also from the neighbors; leaves `isolated` as it is.
/// Requires: neighbors were computed.
void keep_within(std::span<const Point> points, double alpha, AlphaComplex& delaunay);

}  // namespace rbpa
