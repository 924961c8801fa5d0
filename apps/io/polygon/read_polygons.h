// What:   polygons from a file of any format we read, and sizes at points from lines of text.
// Source: .poly is Shewchuk, Triangle, https://www.cs.cmu.edu/~quake/triangle.poly.html
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/polygon/polygon_file.h"
#include "rbpa/fill.h"

namespace rbpa::app {

/// The polygons in the order of the file. `path` may be "-", standard input; a gzip file is read as what was compressed.
/// Throws BadInput naming the file and the line, what was found and what was expected; Failure; Cancelled.
PolygonFile read_polygons(const std::string& path, Format format);

/// Three numbers a line, x, y and size, with blanks, commas, semicolons or tabs between them; blank lines and those that
/// begin with # are passed over, and so is a first line of names. `path` may be "-". Throws BadInput naming the line;
/// Failure; Cancelled.
std::vector<SizeAt> read_sizes(const std::string& path);

/// The segments have to make rings: two at each vertex, or none. A ring within another bounds a hole, in which there is a
/// hole point. Attributes, markers and regions are passed over; vertices in a file of their own (.node) are not looked for.
/// Throws BadInput naming the line, or what of the rings is wrong; Cancelled.
PolygonFile read_poly_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app
