#include "io/formats.h"

#include <algorithm>
#include <cctype>

#include "io/failure.h"

namespace rbpa::app {
namespace {

/// Whether `name`, in letters of either case, is among the lower-case names of `known`.
bool same(std::string_view name, std::string_view known) {
  const auto same_letter = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return std::equal(name.begin(), name.end(), known.begin(), known.end(), same_letter);
}

/// Names, separated by blanks.
struct Named {
  std::string_view names;
  Format format;
  unsigned uses;
};
constexpr unsigned operator|(Use a, Use b) { return static_cast<unsigned>(a) | static_cast<unsigned>(b); }
constexpr unsigned operator|(unsigned a, Use b) { return a | static_cast<unsigned>(b); }
constexpr unsigned only(Use use) { return static_cast<unsigned>(use); }
constexpr Named formats[] = {
    {"txt csv tsv xyz text", Format::text, Use::points | Use::space},
    {"xy", Format::text, only(Use::points)},
    {"pts", Format::pts, Use::points | Use::space},
    {"xyzn", Format::xyzn, Use::points | Use::space},
    {"xyzrgb", Format::xyzrgb, Use::points | Use::space},
    {"npy", Format::npy, Use::points | Use::space | Use::triangles | Use::surface | Use::solid},
    {"f64xy", Format::raw, only(Use::points)},
    {"las", Format::las, Use::points | Use::space},
    {"off", Format::off, Use::points | Use::space | Use::mesh | Use::triangles | Use::surface},
    {"ply", Format::ply, Use::points | Use::space | Use::mesh | Use::triangles | Use::surface},
    {"obj", Format::obj,
     Use::space | Use::mesh | Use::triangles | Use::surface | Use::polylines | Use::voids | Use::cycles},
    {"stl", Format::stl, Use::mesh | Use::surface},
    {"pcd", Format::pcd, only(Use::space)},
    {"pdb ent", Format::pdb, only(Use::space)},
    {"cif mmcif", Format::cif, only(Use::space)},
    {"png", Format::png, Use::points | Use::triangles | Use::surface | Use::shape | Use::solid},
    {"pgm", Format::pgm, only(Use::points)},
    {"svg", Format::svg, Use::triangles | Use::shape},
    {"vtu", Format::vtu, Use::triangles | Use::surface | Use::solid | Use::cycles},
    {"glb", Format::glb, only(Use::surface)},
    {"mesh", Format::medit, only(Use::solid)},
    {"msh", Format::gmsh, only(Use::solid)},
    {"wkt", Format::wkt, Use::points | Use::polygons | Use::shape},
    {"ewkt", Format::wkt, Use::points | Use::polygons},
    {"ewkt", Format::ewkt, only(Use::shape)},
    {"geojson json", Format::geojson, Use::points | Use::polygons | Use::shape | Use::triangles},
    {"geojsonl geojsons ndjson", Format::geojson, Use::points | Use::polygons},
    {"poly", Format::poly, only(Use::polygons)},
    {"csv", Format::csv, Use::shape | Use::levels | Use::voids},
    {"json", Format::json, Use::levels | Use::polylines | Use::voids | Use::cycles},
    {"ogr gpkg fgb shp kml gpx gml", Format::ogr, only(Use::points)},
    {"gpkg", Format::gpkg, Use::shape | Use::triangles},
    {"fgb", Format::fgb, Use::shape | Use::triangles},
    {"shp", Format::shp, Use::shape | Use::triangles}};

bool is_among(std::string_view name, std::string_view names) {
  while (!names.empty()) {
    const std::size_t size = std::min(names.find(' '), names.size());
    if (same(name, names.substr(0, size))) return true;
    names.remove_prefix(std::min(size + 1, names.size()));
  }
  return false;
}

/// Returns a command that converts a file with that ending to a format that is read; empty if none is known.
std::string conversion(std::string_view ending, const std::string& path) {
  if (const std::string command = cloud_conversion(path); !command.empty()) return command;
  if (is_among(ending, "shp gpkg fgb kml kmz gpx gml parquet gdb tab mif dxf osm pbf sqlite ods xlsx"))
    return "ogr2ogr -f GeoJSON points.geojson " + path;
  return "";
}

}  // namespace

std::string cloud_conversion(const std::string& path) {
  return is_among(input_ending(path), "laz zlas e57 pcd ptx bpf rdb copc") ? "pdal translate " + path + " points.las"
                                                                           : "";
}

std::optional<Format> find_format(Use use, std::string_view name) {
  for (const Named& known : formats)
    if ((known.uses & only(use)) != 0 && is_among(name, known.names)) return known.format;
  return std::nullopt;
}

std::string_view ending(std::string_view path) {
  path.remove_prefix(path.rfind('/') + 1);
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
}

bool is_gzip_name(std::string_view path) { return path.ends_with(".gz") || path.ends_with(".GZ"); }

std::string_view input_ending(std::string_view path) {
  if (is_gzip_name(path)) path.remove_suffix(3);
  return ending(path);
}

void refuse_name(const std::string& option, std::string_view name, std::string_view known) {
  throw WrongUsage(option + ": found " + in_quotes(name) + ", expected one of " + std::string(known));
}

void refuse_ending(const std::string& path, std::string_view known, const std::string& option) {
  throw WrongUsage(path + ": found the ending " + in_quotes(ending(path)) + ", expected one of " + std::string(known) +
                   ", or " + option);
}

void refuse_input(const std::string& path, std::string_view known, const std::string& option) {
  try {
    refuse_ending(path, known, option);
  } catch (const WrongUsage& refusal) {
    const std::string command = conversion(input_ending(path), path);
    throw WrongUsage(refusal.what() + (command.empty() ? "" : " (" + command + ")"));
  }
}

}  // namespace rbpa::app
