// What:   reads polygons from a file of any supported format, and sizes at points from lines of text.
// Source: .poly: Shewchuk, Triangle, https://www.cs.cmu.edu/~quake/triangle.poly.html
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/polygon/polygon_file.h"
#include "rbpa/fill.h"

namespace rbpa::app {

/// Reads the polygons in the order of the file. `path` may be "-", standard input; a gzip file is decompressed. Throws
/// BadInput that names the file and the line, what was found and what was expected; Failure; Cancelled. Requires: a
/// format of Use::polygons.
PolygonFile read_polygons(const std::string& path, Format format);

/// Reads three numbers per line, x, y and size, separated by blanks, commas, semicolons or tabs. Skips blank lines,
/// lines that begin with #, and a first line of names. `path` may be "-". Throws BadInput that names the line; Failure;
/// Cancelled.
std::vector<SizeAt> read_sizes(const std::string& path);

/// Reads a .poly file. Its segments must form rings: two at each vertex, or none. A ring directly within a shell bounds
/// a hole, in which there must be a hole point. Ignores attributes, markers and regions; does not read vertices from a
/// .node file. Throws BadInput that names the line, or the fault of the rings; Cancelled.
PolygonFile read_poly_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app
