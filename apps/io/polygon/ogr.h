// What: vector files by GDAL: reads any source of OGR; writes GeoPackage, FlatGeobuf and Shapefile. A build without
//       GDAL (RBPA_WITH_GDAL, off by default) has stubs that throw WrongUsage.
// Law:  coordinates stay the same doubles; files keep the system of coordinates.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/point_file.h"
#include "io/polygon/shape_files.h"

namespace rbpa::app {

/// Reads the points and multipoints of a layer, and with `vertices` the vertices of all geometries; the point at which
/// a ring closes counts once. `layer` may be absent if there is only one. Throws BadInput with GDAL's message.
PointFile read_ogr_points(const std::string& source, const std::optional<std::string>& layer, bool vertices);

/// A written file, wholly in memory.
struct OgrFile {
  std::string ending;  ///< "gpkg"; "shp", "shx", "dbf" and so on
  std::string bytes;
};

/// Returns whether GDAL writes the format.
inline bool is_ogr(Format format) { return format == Format::gpkg || format == Format::fgb || format == Format::shp; }
/// Returns the endings of the files of a format, that of the main file first.
inline std::vector<std::string> ogr_endings(Format format) {
  if (format == Format::gpkg) return {"gpkg"};
  if (format == Format::fgb) return {"fgb"};
  return {"shp", "shx", "dbf", "prj", "cpg"};
}

/// Writes polygons with their number, area, perimeter, holes and points; in a GeoPackage also the isolated points, as a
/// layer "isolated". This and the functions below throw Failure with GDAL's message. Requires: is_ogr(format).
std::vector<OgrFile> ogr_polygons(Format format, const Shape& shape);
/// Writes a multipolygon for each group, with group, points, alpha, area, perimeter, polygons and problem as in
/// GeoJSON. A group without a polygon has no geometry, and is left out of a FlatGeobuf.
std::vector<OgrFile> ogr_groups(Format format, const NamedShapes& groups);
/// Writes triangles with their number and attributes, and with heights if they have some.
std::vector<OgrFile> ogr_triangles(Format format, const TriangleList& triangles);
/// Writes the points in no polygon, with their input indices.
std::vector<OgrFile> ogr_isolated(Format format, const Shape& shape);

}  // namespace rbpa::app
