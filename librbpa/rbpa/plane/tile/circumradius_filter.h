// What: tests which triangles on a tile have a circumradius ≤ alpha, as far as single precision decides.
// Law:  `inside` and `outside` are true for the points in double precision; exact arithmetic decides `uncertain`.
// How:  compares ab² bc² ca² with 4 α² (ab × ca)², several triangles at a time; docs/explanation/plane.md, section 10,
//       derives the bounds.
// Cost: a few nanoseconds a triangle.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/plane/tile/coordinates.h"
#include "rbpa/plane/tile/local_front.h"

namespace rbpa {

enum class CircumradiusFilter : std::uint8_t { outside, inside, uncertain };

/// Writes filtered[t] for each triangle t of the front; other entries are undefined.
/// Requires: finite alpha > 0, not scaled; `at` are the coordinates of the tile on which the front stands.
void filter_circumradii(const TileCoordinates& at, const LocalFront& front, double alpha,
                        std::vector<CircumradiusFilter>& filtered);

}  // namespace rbpa
