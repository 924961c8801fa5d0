// What: finds which of the given rings, after noding, lies in which; or reports why and where they cannot be the rings
//       of polygons.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/fill/rings/noded_rings.h"
#include "rbpa/fill/rings/simple_rings.h"

namespace rbpa {

/// Returns what is wrong with rings that meet, in terms of the input: the vertices are those of `rings`.
std::string text_of(const RingsMeet& meet, std::span<const Point> points, std::span<const Ring> rings,
                    const NodedRings& noded, const RingName& name);

/// Returns which ring lies in which.
/// Throws: InvalidInput when rings cross, overlap, or one passes a place twice; Cancelled.
std::vector<RingPlace> place_rings(std::span<const Point> points, std::span<const Ring> rings, const NodedRings& noded,
                                   const RingName& name, const GoOn& go_on);

}  // namespace rbpa
