// What: closed surfaces that lie in others.
// Law:  exact, and a function of the surfaces: a ray from a vertex that touches no other surface decides, of such
//       vertices the lexicographically least. What the ray only touches counts as if the vertex had been moved, by less
//       than any number.
// Cost: for each triangle, the vertices that it covers in the direction of the ray; n log n where surfaces hide few
//       others.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "meshtopo/exact.h"

namespace rbpa::app {

/// Of each closed surface in how many others it lies. One that has no triangle lies in none; one with every vertex on
/// another does not lie in that.
/// Requires: triangles that close each surface. Throws Cancelled.
std::vector<std::size_t> depths(std::span<const Position> positions, std::span<const std::vector<Triangle>> surfaces);

}  // namespace rbpa::app
