// What: the points of a shape as files: in which polygon each is, and those that are in none.
// Law:  coordinates read back to the same doubles; points are in the order of the input.
#pragma once

#include "io/gis/shape.h"
#include "io/output_file.h"

namespace rbpa::app {

/// CSV: x,y,polygon for every point, polygons numbered from 1 as in GeoJSON; nothing where it is in none.
void write_points_csv(OutputFile& file, const Shape& shape);

/// The points in no polygon, with their indices in the input from 0: CSV x,y,index; a GeoJSON FeatureCollection of Points
/// with "index"; or one MULTIPOINT.
void write_isolated_csv(OutputFile& file, const Shape& shape);
void write_isolated_geojson(OutputFile& file, const Shape& shape);
void write_isolated_wkt(OutputFile& file, const Shape& shape);

}  // namespace rbpa::app
