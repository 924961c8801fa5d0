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

/// Returns the text of an error about two rings that meet. `meet` is in terms of `noded`; the text numbers vertices as
/// `rings` does, and calls ring r name(r).
std::string text_of(const RingsMeet& meet, std::span<const Point> points, std::span<const Ring> rings,
                    const NodedRings& noded, const RingName& name);

/// Returns for each ring its position among the others.
/// Throws: InvalidInput when rings cross, overlap, or one passes a place twice; Cancelled.
std::vector<RingPlace> place_rings(std::span<const Point> points, std::span<const Ring> rings, const NodedRings& noded,
                                   const RingName& name, const GoOn& go_on);

}  // namespace rbpa
