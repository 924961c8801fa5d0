// What: reads any source of OGR and writes GeoPackage, FlatGeobuf and Shapefile, by GDAL. In a build without GDAL
//       (RBPA_WITH_GDAL) all functions that call GDAL throw WrongUsage.
// Law:  coordinates are the same doubles before and after; files keep the coordinate system.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/point_file.h"
#include "io/polygon/write_shapes.h"

namespace rbpa::app {

/// Reads the points and multipoints of a layer, and with `vertices` the vertices of all geometries; the point at which
/// a ring closes counts once. Requires: `layer` is present if `source` has several. Throws BadInput with GDAL's
/// message, also if no layer has that name; Cancelled.
PointFile read_ogr_points(const std::string& source, const std::optional<std::string>& layer, bool vertices);

/// A complete file, in memory.
struct OgrFile {
  std::string ending;  ///< "gpkg"; "shp", "shx", "dbf" and so on
  std::string bytes;
};

/// Returns whether GDAL writes the format.
inline bool is_ogr(Format format) { return format == Format::gpkg || format == Format::fgb || format == Format::shp; }
/// Returns the endings of the files of a format, the ending of the main file first. Requires: is_ogr(format).
inline std::vector<std::string> ogr_endings(Format format) {
  if (format == Format::gpkg) return {"gpkg"};
  if (format == Format::fgb) return {"fgb"};
  return {"shp", "shx", "dbf", "prj", "cpg"};
}

/// Returns the files of polygons with number, area, perimeter, holes and points; a GeoPackage also has the isolated
/// points, as a layer "isolated". This function and the functions below throw Failure with GDAL's message; Cancelled.
/// Require: is_ogr(format).
std::vector<OgrFile> ogr_polygons(Format format, const Shape& shape);
/// Returns the files of a multipolygon for each group, with group, points, alpha, area, perimeter, polygons and problem
/// as in GeoJSON. A group without a polygon has no geometry, and is left out of a FlatGeobuf.
std::vector<OgrFile> ogr_groups(Format format, const NamedShapes& groups);
/// Returns the files of triangles with number and attributes, and with heights if triangles.has_z.
std::vector<OgrFile> ogr_triangles(Format format, const TriangleTable& triangles);
/// Returns the files of the points in no polygon, with their input indices and their fields.
std::vector<OgrFile> ogr_isolated(Format format, const Shape& shape);

}  // namespace rbpa::app
