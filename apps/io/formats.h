// What: the file formats by their names and endings, and what each is for.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rbpa::app {

enum class Format {
  text,  // a table, a point a line
  pts,   // one that may begin with the number of points
  xyzn,
  xyzrgb,
  npy,
  npy_edges,  // beside the .npy of the triangles of a full complex
  npy_points,
  raw,
  las,
  off,
  ply,
  obj,
  stl,
  pcd,
  pdb,
  cif,
  png,
  pgm,
  svg,
  vtu,
  glb,
  medit,  // .mesh
  gmsh,   // .msh
  wkt,
  ewkt,
  geojson,
  poly,
  csv,  // as it is written
  json,
  ogr,  // whatever GDAL reads
  gpkg,
  fgb,
  shp,
  by_content  // of standard input, until it is read
};

/// What is read from a file or written to it.
enum class Use : unsigned {
  points = 1U << 0U,     ///< of the plane
  space = 1U << 1U,      ///< points of space
  mesh = 1U << 2U,       ///< in or out
  polygons = 1U << 3U,   ///< in
  triangles = 1U << 4U,  ///< out, or with all of a full complex
  surface = 1U << 5U,    ///< out, in space
  shape = 1U << 6U,      ///< out
  levels = 1U << 7U,     ///< out
  polylines = 1U << 8U,  ///< out
  solid = 1U << 9U,      ///< out: tetrahedra
  voids = 1U << 10U,     ///< out
  cycles = 1U << 11U     ///< out: representatives of pairs in space
};

/// The format that a name stands for: "npy", or the ending of "points.npy". Letters may be of either case.
std::optional<Format> find_format(Use use, std::string_view name);

/// Whether it is a table, of which --columns and --skip-invalid choose columns and lines; or may be one.
constexpr bool is_table(Format format) {
  return format == Format::by_content || format == Format::text || format == Format::pts || format == Format::xyzn ||
         format == Format::xyzrgb;
}

/// The ending of the last part of a path, without its dot; empty when there is none.
std::string_view ending(std::string_view path);

/// Whether the name of a file ends in .gz.
bool is_gzip_name(std::string_view path);

/// The same of a file that is read, which .gz may follow.
std::string_view input_ending(std::string_view path);

/// Throw WrongUsage: `option` was given a name, `path` has an ending, that is none of `known`.
[[noreturn]] void refuse_name(const std::string& option, std::string_view name, std::string_view known);
[[noreturn]] void refuse_ending(const std::string& path, std::string_view known, const std::string& option);
/// The command that makes points that are read of a point cloud in a format that is not, by the ending; empty of others.
std::string cloud_conversion(const std::string& path);
/// The same of a file that is read: where a program is known that makes something of it that we read, it is named.
[[noreturn]] void refuse_input(const std::string& path, std::string_view known, const std::string& option);

/// What there is, for messages and help; what GDAL adds is beside it.
constexpr std::string_view point_formats =
    "xy, txt, csv, tsv, xyz, pts, xyzn, xyzrgb, las, geojson, wkt, ewkt, npy, off, ply, f64xy, png, pgm";
constexpr std::string_view space_formats =
    "xyz, txt, csv, tsv, pts, xyzn, xyzrgb, ply, off, obj, pcd, npy, las, pdb, cif";
constexpr std::string_view mesh_formats = "off, ply, obj, stl";
constexpr std::string_view polyline_formats = "obj, json";
constexpr std::string_view void_formats = "obj, json, csv";
constexpr std::string_view cycle_formats = "obj, json, vtu";
constexpr std::string_view output_formats = "off, ply, obj, npy, vtu, geojson, json, svg, png";
constexpr std::string_view full_output_formats = "obj, npy, vtu, svg, png";  // of the full complex
constexpr std::string_view surface_formats = "ply, off, obj, stl, glb, vtu, npy, png";
constexpr std::string_view solid_formats = "vtu, msh, mesh, npy, png";
constexpr std::string_view shape_formats = "geojson, json, wkt, ewkt, csv, svg, png";
constexpr std::string_view polygon_formats = "geojson, json, wkt, ewkt, poly";
constexpr std::string_view isolated_formats = "geojson, json, wkt, ewkt, csv";

}  // namespace rbpa::app
