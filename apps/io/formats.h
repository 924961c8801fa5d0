// What: the file formats by their names and endings.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rbpa::app {

enum class PointFormat { text, npy, off, ply, raw, png, pgm, las, wkt, geojson, ogr };
/// Of points of space.
enum class SpaceFormat { text, ply, off, obj, pcd, npy, las };
enum class MeshFormat { off, ply, obj, stl };
enum class PolylineFormat { obj, json };
/// Triangles, or with all of a full complex. Its edges and points are files of their own beside the .npy of its triangles.
enum class OutputFormat { off, ply, obj, npy, npy_edges, npy_points, vtu, svg, png };
/// Of surfaces in space.
enum class SurfaceFormat { ply, off, obj, stl, npy, png };
enum class ShapeFormat { geojson, wkt, ewkt, csv, gpkg, fgb, shp, svg, png };
enum class LevelFormat { csv, json };
enum class PolygonFormat { geojson, wkt, poly };

/// The format that a name stands for: "npy", or the ending of "points.npy". Letters may be of either case.
std::optional<PointFormat> point_format(std::string_view name);
std::optional<SpaceFormat> space_format(std::string_view name);
std::optional<MeshFormat> mesh_format(std::string_view name);
std::optional<PolylineFormat> polyline_format(std::string_view name);
std::optional<OutputFormat> output_format(std::string_view name);
std::optional<SurfaceFormat> surface_format(std::string_view name);
std::optional<ShapeFormat> shape_format(std::string_view name);
std::optional<LevelFormat> level_format(std::string_view name);
std::optional<PolygonFormat> polygon_format(std::string_view name);

/// The ending of the last part of a path, without its dot; empty when there is none.
std::string_view ending(std::string_view path);

/// The same of a file that is read, which .gz may follow.
std::string_view input_ending(std::string_view path);

/// Throw WrongUsage: `option` was given a name, `path` has an ending, that is none of `known`.
[[noreturn]] void refuse_name(const std::string& option, std::string_view name, std::string_view known);
[[noreturn]] void refuse_ending(const std::string& path, std::string_view known, const std::string& option);
/// The same of a file that is read: where a program is known that makes something of it that we read, it is named.
[[noreturn]] void refuse_input(const std::string& path, std::string_view known, const std::string& option);

/// What there is, for messages and help; what GDAL adds is beside it.
constexpr std::string_view point_formats =
    "xy, txt, csv, tsv, xyz, las, geojson, wkt, ewkt, npy, off, ply, f64xy, png, pgm";
constexpr std::string_view space_formats = "xyz, txt, csv, tsv, ply, off, obj, pcd, npy, las";
constexpr std::string_view mesh_formats = "off, ply, obj, stl";
constexpr std::string_view polyline_formats = "obj, json";
constexpr std::string_view output_formats = "off, ply, obj, npy, vtu, svg, png";
constexpr std::string_view full_output_formats = "obj, npy, vtu, svg, png";  // of the full complex
constexpr std::string_view surface_formats = "ply, off, obj, stl, npy, png";
constexpr std::string_view shape_formats = "geojson, json, wkt, ewkt, csv, svg, png";
constexpr std::string_view polygon_formats = "geojson, json, wkt, ewkt, poly";
constexpr std::string_view isolated_formats = "geojson, json, wkt, ewkt, csv";

}  // namespace rbpa::app
