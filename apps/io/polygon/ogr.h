// What: vector files by GDAL: any source of OGR in; GeoPackage, FlatGeobuf and Shapefile out. In a build without GDAL
//       (RBPA_WITH_GDAL, off by default) nothing of it is there but has_gdal(), which says so.
// Law:  coordinates are the same doubles; a system of coordinates goes with them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/point_file.h"
#include "io/polygon/shape_files.h"
#include "io/polygon/triangle_features.h"

namespace rbpa::app {

/// Whether this program was built with GDAL. Without it the functions below throw WrongUsage.
bool has_gdal();

/// Points and multipoints of a layer, and with `vertices` the vertices of all geometries; the point at which a ring
/// closes counts once. The layer may be left out where there is one. Throws BadInput with what GDAL says.
PointFile read_ogr_points(const std::string& source, const std::optional<std::string>& layer, bool vertices);

/// A file that is made, whole in memory.
struct OgrFile {
  std::string ending;  ///< "gpkg"; "shp", "shx", "dbf" and so on
  std::string bytes;
};

/// A format of Format that GDAL writes.
inline bool is_ogr(Format format) { return format == Format::gpkg || format == Format::fgb || format == Format::shp; }
/// The endings of its files, its own first.
inline std::vector<std::string> ogr_endings(Format format) {
  if (format == Format::gpkg) return {"gpkg"};
  if (format == Format::fgb) return {"fgb"};
  return {"shp", "shx", "dbf", "prj", "cpg"};
}

/// Polygons with their number, area, perimeter, holes and points; in a GeoPackage also the isolated points, as a layer of
/// that name. Throws Failure with what GDAL says. Requires: is_ogr(format).
std::vector<OgrFile> ogr_polygons(Format format, const Shape& shape);
/// A multipolygon for each group, with its group, points, alpha, area, perimeter, polygons and problem, as GeoJSON has them; without a
/// geometry where there is no polygon, which a FlatGeobuf leaves out.
std::vector<OgrFile> ogr_groups(Format format, const NamedShapes& groups);
/// Triangles with their number and attributes, and with heights where they have some.
std::vector<OgrFile> ogr_triangles(Format format, const TriangleList& triangles);
/// The points in no polygon, with their indices.
std::vector<OgrFile> ogr_isolated(Format format, const Shape& shape);

}  // namespace rbpa::app
