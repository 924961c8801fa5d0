#include "io/formats.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "io/failure.h"
#include "io/gunzip.h"

namespace rbpa::app {
namespace {

/// `known` is in small letters.
bool same(std::string_view name, std::string_view known) {
  const auto same_letter = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return std::equal(name.begin(), name.end(), known.begin(), known.end(), same_letter);
}

template <typename Format, std::size_t count>
std::optional<Format> find(const std::pair<std::string_view, Format> (&known)[count], std::string_view name) {
  for (const auto& [text, format] : known)
    if (same(name, text)) return format;
  return std::nullopt;
}

/// The command that makes of a file with that ending one that is read; empty when there is none.
std::string conversion(std::string_view ending, const std::string& path) {
  constexpr std::string_view clouds[] = {"laz", "e57", "pcd", "ptx", "pts", "bpf", "rdb", "copc"};
  constexpr std::string_view layers[] = {"shp", "gpkg", "fgb", "kml", "kmz", "gpx",    "gml", "parquet", "gdb",
                                         "tab", "mif",  "dxf", "osm", "pbf", "sqlite", "ods", "xlsx"};
  const auto is_one_of = [&](const auto& known) {
    return std::any_of(std::begin(known), std::end(known), [&](std::string_view text) { return same(ending, text); });
  };
  if (is_one_of(clouds)) return "pdal translate " + path + " points.las";
  if (is_one_of(layers)) return "ogr2ogr -f GeoJSON points.geojson " + path;
  return "";
}

}  // namespace

std::optional<PointFormat> point_format(std::string_view name) {
  constexpr std::pair<std::string_view, PointFormat> known[] = {
      {"xy", PointFormat::text},          {"txt", PointFormat::text},       {"csv", PointFormat::text},
      {"tsv", PointFormat::text},         {"xyz", PointFormat::text},       {"text", PointFormat::text},
      {"npy", PointFormat::npy},          {"off", PointFormat::off},        {"ply", PointFormat::ply},
      {"f64xy", PointFormat::raw},        {"png", PointFormat::png},        {"pgm", PointFormat::pgm},
      {"las", PointFormat::las},          {"wkt", PointFormat::wkt},        {"ewkt", PointFormat::wkt},
      {"geojson", PointFormat::geojson},  {"json", PointFormat::geojson},   {"geojsonl", PointFormat::geojson},
      {"geojsons", PointFormat::geojson}, {"ndjson", PointFormat::geojson}, {"ogr", PointFormat::ogr},
      {"gpkg", PointFormat::ogr},         {"fgb", PointFormat::ogr},        {"shp", PointFormat::ogr},
      {"kml", PointFormat::ogr},          {"gpx", PointFormat::ogr},        {"gml", PointFormat::ogr}};
  return find(known, name);
}

std::optional<SpaceFormat> space_format(std::string_view name) {
  constexpr std::pair<std::string_view, SpaceFormat> known[] = {
      {"xyz", SpaceFormat::text},  {"txt", SpaceFormat::text}, {"csv", SpaceFormat::text}, {"tsv", SpaceFormat::text},
      {"text", SpaceFormat::text}, {"ply", SpaceFormat::ply},  {"off", SpaceFormat::off},  {"obj", SpaceFormat::obj},
      {"pcd", SpaceFormat::pcd},   {"npy", SpaceFormat::npy},  {"las", SpaceFormat::las}};
  return find(known, name);
}

std::optional<MeshFormat> mesh_format(std::string_view name) {
  constexpr std::pair<std::string_view, MeshFormat> known[] = {
      {"off", MeshFormat::off}, {"ply", MeshFormat::ply}, {"obj", MeshFormat::obj}, {"stl", MeshFormat::stl}};
  return find(known, name);
}

std::optional<PolylineFormat> polyline_format(std::string_view name) {
  constexpr std::pair<std::string_view, PolylineFormat> known[] = {{"obj", PolylineFormat::obj},
                                                                   {"json", PolylineFormat::json}};
  return find(known, name);
}

std::optional<OutputFormat> output_format(std::string_view name) {
  constexpr std::pair<std::string_view, OutputFormat> known[] = {
      {"off", OutputFormat::off}, {"ply", OutputFormat::ply}, {"obj", OutputFormat::obj}, {"npy", OutputFormat::npy},
      {"vtu", OutputFormat::vtu}, {"svg", OutputFormat::svg}, {"png", OutputFormat::png}};
  return find(known, name);
}

std::optional<SurfaceFormat> surface_format(std::string_view name) {
  constexpr std::pair<std::string_view, SurfaceFormat> known[] = {
      {"ply", SurfaceFormat::ply}, {"off", SurfaceFormat::off}, {"obj", SurfaceFormat::obj},
      {"stl", SurfaceFormat::stl}, {"npy", SurfaceFormat::npy}, {"png", SurfaceFormat::png}};
  return find(known, name);
}

std::optional<ShapeFormat> shape_format(std::string_view name) {
  constexpr std::pair<std::string_view, ShapeFormat> known[] = {
      {"geojson", ShapeFormat::geojson}, {"json", ShapeFormat::geojson}, {"wkt", ShapeFormat::wkt},
      {"ewkt", ShapeFormat::ewkt},       {"csv", ShapeFormat::csv},      {"gpkg", ShapeFormat::gpkg},
      {"fgb", ShapeFormat::fgb},         {"shp", ShapeFormat::shp},      {"svg", ShapeFormat::svg},
      {"png", ShapeFormat::png}};
  return find(known, name);
}

std::optional<LevelFormat> level_format(std::string_view name) {
  constexpr std::pair<std::string_view, LevelFormat> known[] = {{"csv", LevelFormat::csv}, {"json", LevelFormat::json}};
  return find(known, name);
}

std::optional<PolygonFormat> polygon_format(std::string_view name) {
  constexpr std::pair<std::string_view, PolygonFormat> known[] = {
      {"geojson", PolygonFormat::geojson},  {"json", PolygonFormat::geojson},   {"geojsonl", PolygonFormat::geojson},
      {"geojsons", PolygonFormat::geojson}, {"ndjson", PolygonFormat::geojson}, {"wkt", PolygonFormat::wkt},
      {"ewkt", PolygonFormat::wkt},         {"poly", PolygonFormat::poly}};
  return find(known, name);
}

std::string_view ending(std::string_view path) {
  path.remove_prefix(path.rfind('/') + 1);
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
}

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
