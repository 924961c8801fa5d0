// What:   whether polygons are valid under OGC Simple Features, and where not.
// Law:    decided exactly. A polygon is valid if its rings are simple, do not cross, have at most single points in common,
//         holes lie in the shell and not in each other, and what is left inside is in one piece. Polygons make a valid
//         multipolygon if moreover they have no area and no edge in common. Vertices that follow each other at one place
//         are one.
// Cost:   n log n in the vertices.
// Source: OGC 06-103r4, Simple feature access, 6.1.11 and 6.1.14.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/shape.h"

namespace rbpa {

/// Why the polygons are no valid multipolygon, or the one polygon is not valid: where, what was found and what was expected, in
/// one line that names polygons, holes and vertices from 0; nothing when they are valid. Rings may begin anywhere and go
/// either way round.
/// Throws: Cancelled when `go_on`, which is called every few milliseconds, returns false. Empty: never called.
RBPA_API std::optional<std::string> why_invalid(std::span<const Point> points, std::span<const Polygon> polygons,
                                                const std::function<bool()>& go_on = {});

}  // namespace rbpa
