#include "cli/arguments.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "io/failure.h"
#include "io/number.h"
#include "io/ogr/ogr.h"
#include "io/same_file.h"
#include "io/whole_number.h"
#include "picture/scene.h"

namespace rbpa::app {
namespace {

template <typename Format>
std::vector<TargetOf<Format>> targets_of(std::optional<Format> (*known_format)(std::string_view),
                                         std::string_view known_formats, const std::vector<std::string>& paths,
                                         const std::optional<std::string>& format, bool any_report) {
  std::optional<Format> otherwise;
  if (format) {
    otherwise = known_format(*format);
    if (!otherwise) refuse_name("--output-format", *format, known_formats);
  }
  if (paths.empty() && !any_report) throw WrongUsage("found no -o OUT, expected at least one (or --stats)");
  std::vector<TargetOf<Format>> targets;
  for (const std::string& path : paths) {
    if (path.empty()) throw WrongUsage("-o: found an empty name, expected a path or -");
    std::optional<Format> known = path == "-" ? std::nullopt : known_format(ending(path));
    if (!known) known = otherwise;
    if (!known && path == "-")
      throw WrongUsage("-o -: found no --output-format, expected one of " + std::string(known_formats));
    if (!known) refuse_ending(path, known_formats, "--output-format");
    targets.push_back({path, *known});
  }
  return targets;
}

template <typename Format>
void require_different_files(const std::vector<TargetOf<Format>>& targets, const std::vector<std::string>& reports,
                             const std::string& points) {
  std::vector<std::string> files;
  for (const TargetOf<Format>& target : targets) files.push_back(target.path);
  files.insert(files.end(), reports.begin(), reports.end());
  require_different(files, points, "points");
}

/// "m.npy" is "m.edges.npy", whatever its ending was.
std::string beside(const std::string& path, const std::string& part) {
  const std::size_t size = output_format(ending(path)) ? path.size() - ending(path).size() - 1 : path.size();
  return path.substr(0, size) + "." + part + ".npy";
}

/// The same where edges and points are written as well: an array of each has a file of its own.
std::vector<Target> with_edges_and_points(const std::vector<Target>& targets) {
  std::vector<Target> all;
  for (const Target& target : targets) {
    if (target.format == OutputFormat::off || target.format == OutputFormat::ply)
      throw WrongUsage(target.path + ": found --complex full, expected one of " + std::string(full_output_formats) +
                       ", which have a place for edges and points in no triangle");
    all.push_back(target);
    if (target.format != OutputFormat::npy) continue;
    if (target.path == "-")
      throw WrongUsage("-o -: found --complex full, which makes three .npy files, expected the name of one");
    all.push_back({beside(target.path, "edges"), OutputFormat::npy_edges});
    all.push_back({beside(target.path, "points"), OutputFormat::npy_points});
  }
  return all;
}

std::optional<ShapeFormat> plain_shape_format(std::string_view name) {
  const std::optional<ShapeFormat> format = shape_format(name);
  return format && is_ogr(*format) ? std::nullopt : format;
}

std::string all_shape_formats() { return std::string(shape_formats) + (has_gdal() ? ", gpkg, fgb, shp" : ""); }

}  // namespace

double parse_area(const std::string& option, const std::string& text) {
  const ParsedNumber number = parse_whole_number(text);
  const bool infinite = number.fault == NumberFault::not_finite && number.value > 0;
  if (infinite) return std::numeric_limits<double>::infinity();
  if (number.fault != NumberFault::none || !(number.value >= 0))
    throw WrongUsage(option + ": found " + in_quotes(text) + ", expected an area: a number >= 0, or inf");
  return number.value;
}

int parse_width(const std::string& text) {
  return static_cast<int>(parse_whole("--width", text, {.least = least_width, .greatest = greatest_width}, "pixels"));
}

bool parse_is_full(const std::string& complex) {
  if (complex != "solid" && complex != "full")
    throw WrongUsage("--complex: found " + in_quotes(complex) + ", expected solid or full");
  return complex == "full";
}

std::vector<std::string> given(const std::vector<std::optional<std::string>>& reports) {
  std::vector<std::string> paths;
  for (const auto& report : reports)
    if (report) paths.push_back(*report);
  return paths;
}

std::vector<Target> parse_targets(const std::vector<std::string>& paths, const std::optional<std::string>& format,
                                  const std::vector<std::string>& reports, const std::string& points, Complex complex) {
  std::vector<Target> targets = targets_of(output_format, output_formats, paths, format, !reports.empty());
  if (complex == Complex::full) targets = with_edges_and_points(targets);
  require_different_files(targets, reports, points);
  return targets;
}

std::vector<ShapeTarget> parse_shape_targets(const std::vector<std::string>& paths,
                                             const std::optional<std::string>& format,
                                             const std::vector<std::string>& reports, const std::string& points) {
  // A format of GDAL is an unknown ending where there is no GDAL.
  const std::vector<ShapeTarget> targets =
      targets_of(has_gdal() ? shape_format : plain_shape_format, all_shape_formats(), paths, format, !reports.empty());
  std::vector<std::string> others = reports;
  for (const ShapeTarget& target : targets)
    if (target.format == ShapeFormat::shp) {
      if (target.path == "-") throw WrongUsage("-o -: found shp, which is several files, expected the name of one");
      for (const std::string& path : ogr_paths(target)) others.push_back(path);
      others.erase(std::find(others.begin() + static_cast<std::ptrdiff_t>(reports.size()), others.end(), target.path));
    }
  require_different_files(targets, others, points);
  return targets;
}

std::vector<SurfaceTarget> parse_surface_targets(const std::vector<std::string>& paths,
                                                 const std::optional<std::string>& format,
                                                 const std::vector<std::string>& reports, const std::string& points) {
  const std::vector<SurfaceTarget> targets =
      targets_of(surface_format, surface_formats, paths, format, !reports.empty());
  require_different_files(targets, reports, points);
  return targets;
}

std::vector<std::string> ogr_paths(const ShapeTarget& target) {
  const std::vector<std::string> endings = ogr_endings(target.format);
  if (endings.size() == 1) return {target.path};
  std::vector<std::string> paths;
  // Beside s.shp; of a file with another ending, or none, behind it.
  const bool is_own = shape_format(ending(target.path)) == target.format;
  const std::string stem =
      is_own ? target.path.substr(0, target.path.size() - ending(target.path).size() - 1) : target.path;
  for (const std::string& part : endings) paths.push_back(part == endings.front() ? target.path : stem + "." + part);
  return paths;
}

ShapeTarget parse_isolated(const std::string& path) {
  const std::optional<ShapeFormat> format = (has_gdal() ? shape_format : plain_shape_format)(ending(path));
  constexpr ShapeFormat others[] = {ShapeFormat::svg, ShapeFormat::png, ShapeFormat::shp};
  if (!format || std::find(std::begin(others), std::end(others), *format) != std::end(others))
    throw WrongUsage("--isolated: found the ending " + in_quotes(ending(path)) + ", expected one of " +
                     std::string(isolated_formats) + (has_gdal() ? ", gpkg, fgb" : ""));
  return {path, *format};
}

}  // namespace rbpa::app
