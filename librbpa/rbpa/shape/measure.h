// What: areas and lengths of rings.
// Law:  a function of the ring's edges: of no order.
#pragma once

#include <span>

#include "rbpa/core/point.h"
#include "rbpa/shape/exact_sum.h"
#include "rbpa/shape/polygons.h"

namespace rbpa {

/// Adds twice the area that the ring encloses, exactly: positive when it is counter-clockwise.
void add_twice_area(ExactSum& sum, const Ring& ring, std::span<const Point> points);

/// The area that the ring encloses, whichever way round, rounded once.
double enclosed_area(const Ring& ring, std::span<const Point> points);

/// Fills in area and perimeter. `points` are those of the input, by index.
void measure(Polygon& polygon, std::span<const Point> points);

}  // namespace rbpa
