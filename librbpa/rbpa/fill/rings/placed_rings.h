// What: finds the nesting of rings after noding, or reports why and where the rings cannot be those of polygons.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/fill/rings/noded_rings.h"
#include "rbpa/fill/rings/simple_rings.h"

namespace rbpa {

/// Returns the text of an error about two rings that meet. `meet` refers to edges of `noded`; the text numbers vertices
/// as in `rings`, and calls ring r name(r).
std::string text_of(const RingsMeet& meet, std::span<const Point> points, std::span<const Ring> rings,
                    const NodedRings& noded, const RingName& name);

/// Returns for each ring its position among the others.
/// Throws: InvalidInput when rings cross or overlap, or when a ring contains a point twice; Cancelled.
std::vector<RingPlace> place_rings(std::span<const Point> points, std::span<const Ring> rings, const NodedRings& noded,
                                   const RingName& name, const GoOn& go_on);

}  // namespace rbpa
