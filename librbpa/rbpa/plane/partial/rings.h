// What: splits boundary curves of an open component into rings, removes holes, and makes the polygon of a finished
//       component.
#pragma once

#include <cstddef>
#include <vector>

#include "rbpa/plane/partial.h"
#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Adds the rings of a closed boundary curve, which has triangles on its left, to `component`.
/// Throws: InvalidInput when a ring has fewer than three points: the curve then bounds no triangles. Cost: n log n.
void add_curve(OpenComponent& component, std::vector<Corner>&& curve);

/// Returns whether `a` comes before `b`: by first point, then by second. Each edge is on one ring, so no two rings are
/// equal.
bool ring_before(const CornerRing& a, const CornerRing& b);

/// Returns the polygon of a component all of whose curves are closed.
/// Throws: InvalidInput when no ring is counter-clockwise, so the rings do not bound a component.
CornerPolygon polygon_of(OpenComponent&& component);

/// Removes the holes of a component and returns them in order, if together they have at least `min_corners` corners.
/// The component keeps the sums of these holes, under `name`.
std::vector<CornerRing> holes_out_of(OpenComponent& component, const ComponentName& name, std::size_t min_corners);

/// Adds the sums of the holes removed from `from` to those of `to`, when the two components are merged.
void add_taken(OpenComponent& to, OpenComponent&& from);

}  // namespace rbpa
