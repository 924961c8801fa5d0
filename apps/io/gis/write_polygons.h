// What: polygons as files of geographic information systems.
// Law:  the bytes depend on polygons and points alone; coordinates read back to the same doubles.
#pragma once

#include "io/gis/shape.h"
#include "io/output_file.h"

namespace rbpa::app {

/// GeoJSON (RFC 7946): a FeatureCollection with one Feature for each polygon, whose properties are "number", from 1,
/// "area", "perimeter", "holes", how many, and "points", how many are in it and in none before it. An area beyond the
/// range of double is null. A system other than WGS 84 is a member "crs".
void write_geojson(OutputFile& file, const Shape& shape);

/// Well-known text: one MULTIPOLYGON, or MULTIPOLYGON EMPTY.
void write_wkt(OutputFile& file, const Shape& shape);

}  // namespace rbpa::app
