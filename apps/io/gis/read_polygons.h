// What: polygons from a file of any format we read.
#pragma once

#include <string>

#include "io/formats.h"
#include "io/gis/polygon_file.h"

namespace rbpa::app {

/// The polygons in the order of the file. `path` may be "-", standard input; a gzip file is read as what was compressed.
/// Throws BadInput naming the file and the line, what was found and what was expected; Failure; Cancelled.
PolygonFile read_polygons(const std::string& path, PolygonFormat format);

}  // namespace rbpa::app
