// What: polygons as files of geographic information systems.
// Law:  the bytes depend on polygons and points alone; coordinates read back to the same doubles.
#pragma once

#include <span>

#include "io/output_file.h"
#include "rbpa/core/point.h"
#include "rbpa/shape/polygons.h"

namespace rbpa::app {

/// GeoJSON (RFC 7946): a FeatureCollection with one Feature for each polygon, whose properties are "area", "perimeter"
/// and "holes", how many. An area beyond the range of double is null.
void write_geojson(OutputFile& file, std::span<const Polygon> polygons, std::span<const Point> points);

/// Well-known text: one MULTIPOLYGON, or MULTIPOLYGON EMPTY.
void write_wkt(OutputFile& file, std::span<const Polygon> polygons, std::span<const Point> points);

}  // namespace rbpa::app
