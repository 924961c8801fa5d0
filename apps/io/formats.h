// What: the file formats with their names, endings and uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rbpa::app {

enum class Format {
  text,  // a table, one point per line
  pts,   // a table that may begin with the number of points
  xyzn,
  xyzrgb,
  npy,
  npy_edges,  // written beside the .npy of the triangles of a full complex
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
  csv,  // output only; input of this ending is text
  json,
  ogr,  // any format that GDAL reads
  gpkg,
  fgb,
  shp,
  by_content  // standard input, until its content shows the format
};

/// The data that are read from a file or written to it.
enum class Use : unsigned {
  points = 1U << 0U,     ///< in: points in the plane
  space = 1U << 1U,      ///< in: points in space
  mesh = 1U << 2U,       ///< in or out
  polygons = 1U << 3U,   ///< in
  triangles = 1U << 4U,  ///< out: triangles of the plane, or all simplices of a full complex
  surface = 1U << 5U,    ///< out, in space
  shape = 1U << 6U,      ///< out
  levels = 1U << 7U,     ///< out
  polylines = 1U << 8U,  ///< out
  solid = 1U << 9U,      ///< out: tetrahedra
  voids = 1U << 10U,     ///< out
  cycles = 1U << 11U     ///< out: representatives of pairs in space
};

/// Returns the format of a name, "npy", or of the ending of a path, "points.npy", in letters of either case.
std::optional<Format> find_format(Use use, std::string_view name);

/// Whether the format is, or may turn out to be, a table, to which --columns and --skip-invalid apply.
constexpr bool is_table(Format format) {
  return format == Format::by_content || format == Format::text || format == Format::pts || format == Format::xyzn ||
         format == Format::xyzrgb;
}

/// Returns the ending of a file name, without its dot; empty if there is none.
std::string_view ending(std::string_view path);

/// Whether the name of a file ends in .gz.
bool is_gzip_name(std::string_view path);

/// Returns the ending of an input file, before any .gz.
std::string_view input_ending(std::string_view path);

/// Throw WrongUsage: the name given to `option`, or the ending of `path`, is not among `known`.
[[noreturn]] void refuse_name(const std::string& option, std::string_view name, std::string_view known);
[[noreturn]] void refuse_ending(const std::string& path, std::string_view known, const std::string& option);
/// Returns a command that converts a point cloud in a format that is not read, by its ending; empty for other endings.
std::string cloud_conversion(const std::string& path);
/// Throws WrongUsage for an input file, as refuse_ending(), and names a command that converts the file if one is known.
[[noreturn]] void refuse_input(const std::string& path, std::string_view known, const std::string& option);

/// Lists of endings for messages and help, without those that GDAL adds.
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
