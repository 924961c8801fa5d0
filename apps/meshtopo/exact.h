// What: questions about positions, answered exactly: which way a closed surface faces, and whether two places
//       are near.
// Law:  the answer is that of the real numbers, at any magnitude: rounded numbers decide where they certainly can, and
//       whole numbers of any length elsewhere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/mesh/equal_positions.h"

namespace rbpa::app {

using Triangle = std::array<std::uint32_t, 3>;

/// The sign of the volume that a closed surface encloses: 1 where its triangles face outward, on the whole, −1 where they
/// face what they enclose, 0 where that is nothing. Cost: linear. Throws Cancelled.
int volume_sign(std::span<const Position> positions, std::span<const Triangle> triangles);

/// Whether two places are at most `distance` from each other. Requires: 0 ≤ distance < ∞.
bool are_within(const Position& a, const Position& b, double distance);

}  // namespace rbpa::app
