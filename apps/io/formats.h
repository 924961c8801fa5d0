// What: the table of file formats: their endings and their uses. Help, messages and tests list formats by it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rbpa::app {

/// Functions and properties of a format of points (io/cloud/cloud.h), defined by the source that reads the format.
struct CloudFormat;
extern const CloudFormat table_reader, pts_reader, xyzn_reader, xyzrgb_reader, las_reader, npy_reader, raw_reader,
    ply_reader, off_reader, obj_reader, pcd_reader, pdb_reader, pqr_reader, cif_reader, gro_reader, dump_reader,
    kitti_reader;

enum class Format {
  text,  // a table, one point per line
  pts,   // a table that may begin with the number of points
  xyzn,
  xyzrgb,
  npy,
  npy_edges,  // written next to the .npy of the triangles of a full complex
  npy_points,
  raw,
  kitti,  // .bin
  las,
  laz,
  off,
  ply,
  obj,
  stl,
  pcd,
  pdb,
  pqr,
  cif,
  gro,
  dump,  // of LAMMPS
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
  pml,        // script of PyMOL
  cxc,        // script of ChimeraX
  esri_grid,  // .asc
  ogr,        // any format that GDAL reads
  gpkg,
  fgb,
  shp,
  by_content  // standard input, until its content shows the format
};

/// A kind of data that is read from a file or written to one. The values are bits, and `|` makes a set of them.
enum class Use : unsigned {
  points = 1U << 0U,     ///< in: points in the plane
  space = 1U << 1U,      ///< in: points in space
  mesh = 1U << 2U,       ///< in or out
  polygons = 1U << 3U,   ///< in
  triangles = 1U << 4U,  ///< out: triangles of the plane
  surface = 1U << 5U,    ///< out, in space
  shape = 1U << 6U,      ///< out: outline polygons
  levels = 1U << 7U,     ///< out: the table of --levels
  polylines = 1U << 8U,  ///< out: lines in space
  solid = 1U << 9U,      ///< out: tetrahedra
  voids = 1U << 10U,     ///< out: voids of a solid
  cycles = 1U << 11U,    ///< out: representative cycles of persistence pairs in space
  full = 1U << 12U,      ///< out: triangles of the plane with edges and points in no triangle
  isolated = 1U << 13U,  ///< out: points in no polygon
  boundary = 1U << 14U,  ///< out: a surface as a mesh, no picture
  rows = 1U << 15U,      ///< out: rows of a table of atoms
  lined = 1U << 16U,     ///< out: voids between atoms, with the atoms that line them
  heights = 1U << 17U    ///< out: rasters and contour lines
};
constexpr unsigned operator|(Use a, Use b) { return static_cast<unsigned>(a) | static_cast<unsigned>(b); }
constexpr unsigned operator|(unsigned a, Use b) { return a | static_cast<unsigned>(b); }

/// A row of the table of formats.
struct FormatRow {
  std::string_view endings;  ///< separated by blanks; help and messages list them
  std::string_view aliases;  ///< further endings and names, which are not listed
  Format format;
  unsigned uses;                        ///< of Use, joined by |
  const CloudFormat* points = nullptr;  ///< reader of points; null for geometries and pixels, which are not columns

  constexpr bool is_for(Use use) const { return (uses & static_cast<unsigned>(use)) != 0; }
};

/// All formats, in the order in which help and messages list them. A format may have several rows, but an ending only
/// one for each use.
inline constexpr FormatRow format_table[] = {
    {"xy", "", Format::text, 0U | Use::points, &table_reader},
    {"txt csv tsv xyz", "text", Format::text, Use::points | Use::space, &table_reader},
    {"pts", "", Format::pts, Use::points | Use::space, &pts_reader},
    {"xyzn", "", Format::xyzn, Use::points | Use::space, &xyzn_reader},
    {"xyzrgb", "", Format::xyzrgb, Use::points | Use::space, &xyzrgb_reader},
    {"las", "", Format::las, Use::points | Use::space, &las_reader},
    {"laz", "copc", Format::laz, Use::points | Use::space, &las_reader},
    {"bin", "", Format::kitti, Use::points | Use::space, &kitti_reader},
    {"off", "", Format::off, Use::points | Use::space | Use::mesh | Use::triangles | Use::surface | Use::boundary,
     &off_reader},
    {"ply", "", Format::ply, Use::points | Use::space | Use::mesh | Use::triangles | Use::surface | Use::boundary,
     &ply_reader},
    {"obj", "", Format::obj,
     Use::space | Use::mesh | Use::triangles | Use::full | Use::surface | Use::boundary | Use::polylines | Use::voids |
         Use::lined | Use::cycles,
     &obj_reader},
    {"stl", "", Format::stl, Use::mesh | Use::surface | Use::boundary},
    {"pcd", "", Format::pcd, 0U | Use::space, &pcd_reader},
    {"pdb", "ent", Format::pdb, 0U | Use::space, &pdb_reader},
    {"cif", "mmcif", Format::cif, 0U | Use::space, &cif_reader},
    {"pqr", "", Format::pqr, 0U | Use::space, &pqr_reader},
    {"gro", "", Format::gro, 0U | Use::space, &gro_reader},
    {"dump", "lammpstrj lammpsdump", Format::dump, 0U | Use::space, &dump_reader},
    {"asc", "", Format::esri_grid, 0U | Use::heights},
    {"npy", "", Format::npy,
     Use::points | Use::space | Use::triangles | Use::full | Use::surface | Use::boundary | Use::solid | Use::heights,
     &npy_reader},
    {"f64xy", "", Format::raw, 0U | Use::points, &raw_reader},
    {"json", "", Format::json, Use::levels | Use::polylines | Use::voids | Use::lined | Use::cycles},
    {"glb", "", Format::glb, Use::surface | Use::boundary},
    {"vtu", "", Format::vtu, Use::triangles | Use::full | Use::surface | Use::boundary | Use::solid | Use::cycles},
    {"msh", "", Format::gmsh, 0U | Use::solid},
    {"mesh", "", Format::medit, 0U | Use::solid},
    {"geojson json", "", Format::geojson,
     Use::points | Use::polygons | Use::shape | Use::isolated | Use::triangles | Use::heights},
    {"", "geojsonl geojsons ndjson", Format::geojson, Use::points | Use::polygons},
    {"wkt", "", Format::wkt, Use::points | Use::polygons | Use::shape | Use::isolated | Use::heights},
    {"ewkt", "", Format::wkt, Use::points | Use::polygons},
    {"ewkt", "", Format::ewkt, Use::shape | Use::isolated},
    {"poly", "", Format::poly, 0U | Use::polygons},
    {"csv", "", Format::csv, Use::shape | Use::isolated | Use::levels | Use::voids | Use::lined | Use::rows},
    {"pml", "", Format::pml, 0U | Use::lined},
    {"cxc", "", Format::cxc, 0U | Use::lined},
    {"svg", "", Format::svg, Use::triangles | Use::full | Use::shape | Use::heights},
    {"png", "", Format::png,
     Use::points | Use::triangles | Use::full | Use::surface | Use::shape | Use::solid | Use::heights},
    {"pgm", "", Format::pgm, 0U | Use::points},
    {"gpkg", "", Format::gpkg, Use::shape | Use::triangles | Use::isolated},
    {"fgb", "", Format::fgb, Use::shape | Use::triangles | Use::isolated},
    {"shp", "", Format::shp, Use::shape | Use::triangles},
    {"", "ogr gpkg fgb shp kml gpx gml", Format::ogr, 0U | Use::points}};

/// Returns whether this program was built with GDAL. Without it the formats of GDAL have no use.
bool has_gdal();

/// Returns whether only a build with GDAL reads or writes the ending `name` for the use, and this one has none.
bool lacks_gdal(Use use, std::string_view name);

/// Returns the format of the use that has `name`, such as "npy", as an ending or an alias, in letters of either case.
std::optional<Format> find_format(Use use, std::string_view name);

/// Returns the endings of the formats of a use, for help and messages: "off, ply, obj, stl". With `fits`, returns only
/// the endings of formats for which fits() is true.
std::string endings(Use use, bool (*fits)(Format) = nullptr);

/// Returns whether the format has a row for the use.
bool is_for(Use use, Format format);

/// Returns whether the format is, or may turn out to be, a table, to which --columns and --skip-invalid apply.
constexpr bool is_table(Format format) {
  return format == Format::by_content || format == Format::text || format == Format::pts || format == Format::xyzn ||
         format == Format::xyzrgb;
}

/// Returns whether the format has, or may turn out to have, lines and polygons, to which --vertices applies. A table
/// may have a column of geometries.
constexpr bool has_lines(Format format) {
  return is_table(format) || format == Format::wkt || format == Format::geojson || format == Format::ogr;
}

/// Returns whether the format is LAS or LAZ, for laser scans. Their common reader finds out which of the two a file is.
constexpr bool is_las(Format format) { return format == Format::las || format == Format::laz; }

/// Returns whether points of the format are pixels, to which --foreground and --threshold apply.
constexpr bool is_image(Format format) { return format == Format::png || format == Format::pgm; }

/// Returns the ending of a file name, without its dot; empty if there is none.
std::string_view ending(std::string_view path);

/// Returns whether the name of a file ends in .gz.
bool is_gzip_name(std::string_view path);

/// Returns the ending of a file name without its dot and without ".gz" after it: "csv" for "points.csv.gz".
/// Biological assemblies of the Protein Data Bank, .pdb1 and so on, have the ending pdb.
std::string_view input_ending(std::string_view path);

/// Returns "one of csv, json", or "csv" alone.
std::string one_of(std::string_view known);
/// Throw WrongUsage that says that `name`, the value of `option`, or the ending of `path` is not among `known`.
[[noreturn]] void refuse_name(const std::string& option, std::string_view name, std::string_view known);
[[noreturn]] void refuse_ending(const std::string& path, std::string_view known, const std::string& option);
/// Returns a PDAL command that converts the point cloud `path` to LAS; empty unless its ending is known, such as e57.
std::string cloud_conversion(const std::string& path);
/// Throws WrongUsage for an input file: that it is a folder; or as refuse_ending(), with a command that converts the
/// file if one is known.
[[noreturn]] void refuse_input(const std::string& path, Use use, const std::string& option);

/// Throws WrongUsage "OPTION: found a format FOUND, expected EXPECTED" unless the option fits the format.
void require_format(bool fits, const std::string& option, const std::string& found, const std::string& expected);

}  // namespace rbpa::app
