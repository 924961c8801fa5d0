// What: decides exactly in which direction a closed surface faces, and whether two positions are near each other.
// Law:  the answers are exact for coordinates of any magnitude. Rounded numbers decide if their error bound allows it;
//       otherwise integers of any length decide.
#pragma once

#include <cstdint>
#include <span>

#include "io/mesh/equal_positions.h"

namespace rbpa::app {

using Triangle = std::array<std::uint32_t, 3>;

/// Returns the sign of the volume that a closed surface encloses: 1 if its triangles on the whole face outward, −1 if
/// they face inward, 0 if the volume is 0. Requires: finite positions; triangles that agree in direction. Cost: linear,
/// if rounded numbers decide. Throws Cancelled.
int volume_sign(std::span<const Position> positions, std::span<const Triangle> triangles);

/// Returns whether two positions are at most `distance` apart. Requires: 0 ≤ distance < ∞; finite positions.
bool are_within(const Position& a, const Position& b, double distance);

}  // namespace rbpa::app
