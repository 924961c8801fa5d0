#include "io/formats.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "io/failure.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

/// Returns whether the program has the row: rows of GDAL only if the program was built with GDAL.
bool is_there(const FormatRow& row) {
  constexpr Format of_gdal[] = {Format::ogr, Format::gpkg, Format::fgb, Format::shp};
  return has_gdal() || std::find(std::begin(of_gdal), std::end(of_gdal), row.format) == std::end(of_gdal);
}

/// Returns advice on a file with an ending that is not read, mostly a command that converts it; empty if none is known.
/// `is_table`: tables are among the formats that are read.
std::string conversion(std::string_view ending, const std::string& path, bool is_table) {
  if (path.find("://") != std::string::npos) return "download it first: curl -LO " + path;
  if (const std::string command = cloud_conversion(path); !command.empty()) return command;
  if (is_word_of(ending, "xlsx xls ods dbf")) return "save the sheet as CSV, or ogr2ogr -f CSV points.csv " + path;
  if (is_word_of(ending, "shp gpkg fgb kml kmz gpx gml parquet gdb tab mif dxf osm pbf sqlite"))
    return "ogr2ogr -f GeoJSON points.geojson " + path;
  if (is_word_of(ending, "xtc trr"))
    return "gmx trjconv -f " + path + " -s topol.tpr -o frames.pdb; Python: MDAnalysis";
  if (is_word_of(ending, "dcd nc")) return "MDAnalysis in Python writes it as .pdb";
  if (is_table && is_word_of(ending.empty() ? "dat" : ending, "dat prn asc")) return "--format txt if it is a table";
  return "";
}

}  // namespace

std::string cloud_conversion(const std::string& path) {
  return is_word_of(input_ending(path), "zlas e57 pcd ptx bpf rdb") ? "pdal translate " + path + " points.las" : "";
}

bool lacks_gdal(Use use, std::string_view name) {
  return std::any_of(std::begin(format_table), std::end(format_table), [&](const FormatRow& row) {
    return row.is_for(use) && !is_there(row) && (is_word_of(name, row.endings) || is_word_of(name, row.aliases));
  });
}

std::optional<Format> find_format(Use use, std::string_view name) {
  for (const FormatRow& row : format_table)
    if (row.is_for(use) && is_there(row) && (is_word_of(name, row.endings) || is_word_of(name, row.aliases)))
      return row.format;
  return std::nullopt;
}

std::string endings(Use use, bool (*fits)(Format)) {
  std::string list;
  for (const FormatRow& row : format_table) {
    if (!row.is_for(use) || !is_there(row) || row.endings.empty() || (fits && !fits(row.format))) continue;
    if (!list.empty()) list += ", ";
    for (const char letter : row.endings) list += letter == ' ' ? std::string(", ") : std::string(1, letter);
  }
  return list;
}

bool is_for(Use use, Format format) {
  return std::any_of(std::begin(format_table), std::end(format_table),
                     [&](const FormatRow& row) { return row.format == format && row.is_for(use) && is_there(row); });
}

std::string_view ending(std::string_view path) {
  path.remove_prefix(path.rfind('/') + 1);
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
}

bool is_gzip_name(std::string_view path) { return path.ends_with(".gz") || path.ends_with(".GZ"); }

std::string_view input_ending(std::string_view path) {
  if (is_gzip_name(path)) path.remove_suffix(3);
  const std::string_view found = ending(path), pdb = found.substr(0, 3);
  const bool is_assembly = same_letters(pdb, "pdb") && std::all_of(found.begin() + 3, found.end(), is_digit);
  return is_assembly ? pdb : found;
}

std::string one_of(std::string_view known) {
  return (known.find(',') == std::string_view::npos ? "" : "one of ") + std::string(known);
}

void refuse_name(const std::string& option, std::string_view name, std::string_view known) {
  throw WrongUsage(option + ": found " + in_quotes(name) + ", expected " + one_of(known));
}

void refuse_ending(const std::string& path, std::string_view known, const std::string& option) {
  throw WrongUsage(path + ": found the ending " + in_quotes(ending(path)) + ", expected " + one_of(known) + ", or " +
                   option);
}

void refuse_input(const std::string& path, Use use, const std::string& option) {
  if (std::error_code none; std::filesystem::is_directory(path, none))
    throw WrongUsage(path + ": found a folder, expected a file");
  try {
    refuse_ending(path, endings(use), option);
  } catch (const WrongUsage& refusal) {
    std::string command = conversion(input_ending(path), path, find_format(use, "txt").has_value());
    if (lacks_gdal(use, input_ending(path))) command.insert(0, "this build has no GDAL: ");
    throw WrongUsage(refusal.what() + (command.empty() ? "" : " (" + command + ")"));
  }
}

void require_format(bool fits, const std::string& option, const std::string& found, const std::string& expected) {
  if (!fits) throw WrongUsage(option + ": found a format " + found + ", expected " + expected);
}

}  // namespace rbpa::app
