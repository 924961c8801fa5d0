// What:   tests whether polygons are valid under OGC Simple Features, and reports where and why they are not.
// Law:    all decisions are exact. A polygon is valid if its rings are simple, do not cross, and have at most single
//         points in common, its holes lie in the shell and not in each other, and its interior is connected. A polygon
//         without points is valid. Valid polygons form a valid multipolygon if they have no area and no edge in common.
//         Consecutive vertices with equal coordinates count as one.
// Cost:   n log n in the vertices.
// Source: OGC 06-103r4, Simple feature access, 6.1.11 and 6.1.14.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// Returns the reason why the polygons do not form a valid multipolygon; nothing if they do. Indices that do not exist
/// and coordinates that are not finite are reasons, too. A reason is one line: the place, the violation, and the
/// expected state; numbers count from 0. Rings may begin anywhere and have either orientation.
/// Throws: Cancelled.
RBPA_API std::optional<std::string> why_invalid(std::span<const Point> points, std::span<const Polygon> polygons,
                                                const GoOn& go_on = {});

}  // namespace rbpa
