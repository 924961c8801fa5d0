// What: which triangles on a tile have a circumradius ≤ alpha, as far as single precision tells.
// Law:  `yes` and `no` are true of the points in double precision; `perhaps` is for exact arithmetic to decide.
// How:  ab² bc² ca² against 4 α² (ab × ca)², several triangles at a time; docs/tiles.md, section 5, derives the bounds.
// Cost: a few nanoseconds a triangle.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/tile/coordinates.h"
#include "rbpa/tile/local_front.h"

namespace rbpa {

enum class Within : std::uint8_t { no, yes, perhaps };

/// Replaces `within`: an entry for each triangle of the front by its number, and further ones without a meaning.
/// Requires: alpha > 0, the coordinates of the front's points.
void within_alpha(const TileCoordinates& at, const LocalFront& front, double alpha, std::vector<Within>& within);

}  // namespace rbpa
