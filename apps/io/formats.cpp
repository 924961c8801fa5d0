#include "io/formats.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "io/failure.h"

namespace rbpa::app {
namespace {

template <typename Format, std::size_t count>
std::optional<Format> find(const std::pair<std::string_view, Format> (&known)[count], std::string_view name) {
  const auto same_letter = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  for (const auto& [text, format] : known)
    if (std::equal(name.begin(), name.end(), text.begin(), text.end(), same_letter)) return format;
  return std::nullopt;
}

}  // namespace

std::optional<PointFormat> point_format(std::string_view name) {
  constexpr std::pair<std::string_view, PointFormat> known[] = {
      {"xy", PointFormat::text},  {"txt", PointFormat::text},  {"csv", PointFormat::text}, {"tsv", PointFormat::text},
      {"xyz", PointFormat::text}, {"text", PointFormat::text}, {"npy", PointFormat::npy},  {"off", PointFormat::off},
      {"ply", PointFormat::ply},  {"f64xy", PointFormat::raw}, {"png", PointFormat::png},  {"pgm", PointFormat::pgm}};
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
      {"off", OutputFormat::off}, {"ply", OutputFormat::ply}, {"obj", OutputFormat::obj},
      {"npy", OutputFormat::npy}, {"svg", OutputFormat::svg}, {"png", OutputFormat::png}};
  return find(known, name);
}

std::optional<ShapeFormat> shape_format(std::string_view name) {
  constexpr std::pair<std::string_view, ShapeFormat> known[] = {{"geojson", ShapeFormat::geojson},
                                                                {"json", ShapeFormat::geojson},
                                                                {"wkt", ShapeFormat::wkt},
                                                                {"svg", ShapeFormat::svg},
                                                                {"png", ShapeFormat::png}};
  return find(known, name);
}

std::optional<LevelFormat> level_format(std::string_view name) {
  constexpr std::pair<std::string_view, LevelFormat> known[] = {{"csv", LevelFormat::csv}, {"json", LevelFormat::json}};
  return find(known, name);
}

std::string_view ending(std::string_view path) {
  path.remove_prefix(path.rfind('/') + 1);
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
}

void refuse_name(const std::string& option, std::string_view name, std::string_view known) {
  throw WrongUsage(option + ": found " + in_quotes(name) + ", expected one of " + std::string(known));
}

void refuse_ending(const std::string& path, std::string_view known, const std::string& option) {
  throw WrongUsage(path + ": found the ending " + in_quotes(ending(path)) + ", expected one of " + std::string(known) +
                   ", or " + option);
}

}  // namespace rbpa::app
