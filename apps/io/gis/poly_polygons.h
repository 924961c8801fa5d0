// What:   polygons from a .poly file of Triangle: vertices, the segments between them, and a point in each hole.
// Source: Shewchuk, Triangle, https://www.cs.cmu.edu/~quake/triangle.poly.html
#pragma once

#include <string>
#include <string_view>

#include "io/gis/polygon_file.h"

namespace rbpa::app {

/// The segments have to make rings: two at each vertex, or none. A ring within another bounds a hole, in which there is a
/// hole point. Attributes, markers and regions are passed over; vertices in a file of their own (.node) are not looked for.
/// Throws BadInput naming the line, or what of the rings is wrong; Cancelled.
PolygonFile read_poly_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app
