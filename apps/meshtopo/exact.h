// What: questions about positions, answered exactly: which way a closed surface faces, on which side of a line or a
//       plane a place is, and whether two places are near.
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

/// Seen along x: 1 where `p` is left of the line from `a` to `b`, y to the right and z upward, −1 right of it, 0 on it.
int side_along_x(const Position& a, const Position& b, const Position& p);

/// 1 where `p` is on the side of the plane to which the triangle faces, −1 on the other, 0 on it, or where the corners
/// are on a line.
int side_of_plane(const Position& a, const Position& b, const Position& c, const Position& p);

/// Whether two places are at most `distance` from each other. Requires: 0 ≤ distance < ∞.
bool are_within(const Position& a, const Position& b, double distance);

}  // namespace rbpa::app
