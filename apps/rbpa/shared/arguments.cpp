#include "shared/arguments.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/mesh/ply_fields.h"
#include "io/number.h"
#include "io/polygon/ogr.h"
#include "io/words.h"
#include "picture/scene.h"

namespace rbpa::app {
namespace {

/// Returns " (write s.geojson, then ogr2ogr s.gpx s.geojson)" for a path that only programs of GDAL write; empty for
/// others.
std::string way_to_write(Use use, const std::string& path) {
  const bool is_grid = use == Use::heights && is_word_of(ending(path), "tif tiff");
  if (!is_grid && !is_word_of(ending(path), "shp gpkg fgb kml gml gpx dxf parquet")) return "";
  const std::string first = path.substr(0, path.size() - ending(path).size()) + (is_grid ? "asc" : "geojson");
  return std::string(" (") + (lacks_gdal(use, ending(path)) ? "this build has no GDAL: " : "") + "write " + first +
         ", then " + (is_grid ? "gdal_translate " + first + " " + path : "ogr2ogr " + path + " " + first) + ")";
}

/// Returns the format on standard output, if no option sets one: that of tables is csv.
std::optional<Format> format_of_stream(Use use) {
  constexpr unsigned tables = Use::rows | Use::levels | Use::voids | Use::lined;
  return (tables & static_cast<unsigned>(use)) != 0 ? std::optional(Format::csv) : std::nullopt;
}

std::vector<Target> targets_of(Use use, const OutputArguments& arguments, bool any_report) {
  const std::string known_formats = endings(use);
  std::optional<Format> otherwise;
  if (arguments.output_format) {
    otherwise = find_format(use, *arguments.output_format);
    if (!otherwise) refuse_name("--output-format", *arguments.output_format, known_formats);
  }
  if (arguments.outputs.empty() && !any_report) bad_usage("-o", "no OUT", "at least one (or --stats FILE)");
  std::vector<Target> targets;
  for (const std::string& path : arguments.outputs) {
    if (path.empty()) bad_usage("-o", "an empty name", "a path or -");
    std::optional<Format> known = path == "-" ? std::nullopt : find_format(use, ending(path));
    if (!known) known = otherwise;
    if (!known && path == "-") known = format_of_stream(use);
    if (!known && path == "-") throw WrongUsage("-o - requires --output-format: " + one_of(known_formats));
    if (!known) refuse_ending(path, known_formats, "--output-format" + way_to_write(use, path));
    targets.push_back({path, *known});
  }
  return targets;
}

/// Returns `path` with ".PART.npy" in place of an ending of files of triangles: "m.edges.npy" for "m.npy". Appends
/// ".PART.npy" to a path with any other ending.
std::string beside(const std::string& path, const std::string& part) {
  const std::size_t size =
      find_format(Use::triangles, ending(path)) ? path.size() - ending(path).size() - 1 : path.size();
  return path.substr(0, size) + "." + part + ".npy";
}

/// Returns `targets` with a target for edges and a target for points added after each .npy file. Throws WrongUsage for
/// a format that cannot hold a full complex.
std::vector<Target> with_edges_and_points(const std::vector<Target>& targets) {
  std::vector<Target> all;
  for (const Target& target : targets) {
    if (!is_for(Use::full, target.format))
      bad_usage(target.path, "a format of triangles alone",
                "one of " + endings(Use::full) + " for the edges and points of --complex full (or --complex solid)");
    all.push_back(target);
    if (target.format != Format::npy) continue;
    if (target.path == "-")
      bad_usage("-o -", "standard output for the three .npy files of --complex full", "a file name");
    all.push_back({beside(target.path, "edges"), Format::npy_edges});
    all.push_back({beside(target.path, "points"), Format::npy_points});
  }
  return all;
}

}  // namespace

PolygonFilter parse_areas(const AreaArguments& arguments) {
  const auto parse = [](const char* option, const std::string& text) {
    return parse_real(option, text, {.greatest = std::numeric_limits<double>::infinity()},
                      "an area: a number >= 0, or inf");
  };
  return {.min_hole_area = parse("--min-hole-area", arguments.min_hole_area),
          .min_part_area = parse("--min-part-area", arguments.min_part_area)};
}

std::vector<double> parse_ascending(const std::string& option, const std::string& text, const std::string& or_else) {
  std::vector<double> radii;
  for (const std::string_view word : split_at_commas(text)) {
    const std::string part(word);
    const double radius = parse_real(option, part, above_0, "numbers above 0 with commas between them, or " + or_else);
    if (!radii.empty() && radius <= radii.back())
      bad_usage(option, in_quotes(part) + " after " + text_of(radii.back()), "ascending radii");
    radii.push_back(radius);
  }
  return radii;
}

int parse_width(const std::string& text) {
  return static_cast<int>(parse_whole("--width", text, {.least = least_width, .greatest = greatest_width}, "pixels"));
}

bool parse_is_full(const std::string& complex) {
  if (complex != "solid" && complex != "full") bad_usage("--complex", in_quotes(complex), "solid or full");
  return complex == "full";
}

std::vector<std::string> given(const Reports& reports) {
  std::vector<std::string> paths;
  for (const auto& report : reports)
    if (report) paths.push_back(*report);
  return paths;
}

std::vector<Target> parse_targets(Use use, const OutputArguments& arguments, const std::string& input, Reports reports,
                                  ComplexKind complex) {
  reports.insert(reports.begin(), arguments.run.stats);
  const std::vector<std::string> written = given(reports);
  std::vector<Target> targets = targets_of(use, arguments, !written.empty());
  if (complex == ComplexKind::full) targets = with_edges_and_points(targets);
  std::vector<std::string> files, others;
  for (const Target& target : targets) {
    files.push_back(target.path);
    if (target.format != Format::shp) continue;
    if (target.path == "-") bad_usage("-o -", "standard output for shp, which is several files", "a file name");
    for (const std::string& path : ogr_paths(target))
      if (path != target.path) others.push_back(path);
  }
  files.insert(files.end(), written.begin(), written.end());
  files.insert(files.end(), others.begin(), others.end());
  require_different(files, input, "points");
  return targets;
}

void check_second_input(const SecondInput& second, const FirstInput& first, const std::vector<Target>& targets,
                        const OutputArguments& outputs) {
  if (second.path == "-" && first.path == "-")
    bad_usage(second.option + " -", first.argument + " on standard input as well", "one of them as a file");
  std::vector<std::string> files = given({outputs.run.stats});
  for (const Target& target : targets) files.push_back(target.path);
  require_different(files, second.path, second.content);
}

bool any_of(const std::vector<Target>& targets, bool (*fits)(Format)) {
  return std::any_of(targets.begin(), targets.end(), [&](const Target& target) { return fits(target.format); });
}

bool any_has_vertices(const std::vector<Target>& targets) {
  return any_of(targets, [](Format format) {
    constexpr Format without[] = {Format::svg, Format::png, Format::npy, Format::npy_edges, Format::npy_points};
    return std::find(std::begin(without), std::end(without), format) == std::end(without);
  });
}

std::vector<std::string> ogr_paths(const Target& target) {
  const std::vector<std::string> endings = ogr_endings(target.format);
  if (endings.size() == 1) return {target.path};
  std::vector<std::string> paths;
  // Name the other files after the target without the ending of its format, or after the whole target if it has none.
  const bool is_own = find_format(Use::shape, ending(target.path)) == target.format;
  const std::string stem =
      is_own ? target.path.substr(0, target.path.size() - ending(target.path).size() - 1) : target.path;
  for (const std::string& part : endings) paths.push_back(part == endings.front() ? target.path : stem + "." + part);
  return paths;
}

std::optional<FieldChoice> parse_fields_of(const std::optional<std::string>& text, bool any_holds,
                                           const std::string& required) {
  if (!text) return any_holds ? std::optional(FieldChoice{}) : std::nullopt;
  std::optional<FieldChoice> choice = parse_fields(*text);
  if (choice && !any_holds) throw WrongUsage("--fields requires " + required + ", which hold fields");
  return choice;
}

std::optional<FieldChoice> parse_fields_of(const std::optional<std::string>& text, const std::vector<Target>& meshes) {
  const bool any_holds = any_of(meshes, [](Format format) { return format == Format::ply || format == Format::vtu; });
  return parse_fields_of(text, any_holds, "a mesh in ply or vtu");
}

std::vector<std::string> fields_left_out(const std::vector<PointColumn>& columns, const std::vector<Target>& targets) {
  std::vector<std::string> warnings;
  for (const Target& target : targets)
    for (const PointColumn& column : columns)
      if (target.format == Format::ply && !ply_type(column))
        warnings.push_back("field " + in_quotes(column.name) + " is left out of " + output_name(target.path) +
                           ": no number of PLY holds integers beyond 2^53 (.vtu does)");
  return warnings;
}

std::optional<Shift> parse_shift_of(const std::optional<std::string>& text, const std::vector<Target>& targets) {
  if (!text) return std::nullopt;
  Shift shift = parse_shift("--shift", *text);
  if (!any_of(targets, has_single_precision))
    throw WrongUsage("--shift applies only to .stl and .glb files, which are in single precision");
  return shift;
}

Target target_of(const std::string& option, const std::string& path, Use use, bool (*fits)(Format)) {
  const bool is_stream = path == "-";
  const std::optional<Format> format = is_stream ? format_of_stream(use) : find_format(use, ending(path));
  if (!format || (fits && !fits(*format)))
    bad_usage(option, is_stream ? "standard output" : "the ending " + in_quotes(ending(path)),
              (is_stream ? "a file: " : "") + one_of(endings(use, fits)));
  return {path, *format};
}

Format parse_format(Use use, const std::string& path, const std::optional<std::string>& format,
                    const std::string& argument) {
  if (path.empty()) bad_usage(argument, "an empty name", "a path or -");
  if (!format && path == "-") return Format::by_content;
  const std::optional<Format> found = find_format(use, format ? std::string_view(*format) : input_ending(path));
  if (!found && format) refuse_name("--format", *format, endings(use));
  if (!found) refuse_input(path, use, "--format");
  return *found;
}

std::string list_of(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths) text += (text.empty() ? " -> " : ", ") + output_name(path);
  return text;
}

std::string text_of_polygons(std::size_t polygons, std::size_t holes) {
  return counted(polygons, "polygon") + " with " + counted(holes, "hole");
}

std::string text_of_points(std::size_t points, std::size_t duplicates) {
  return counted(points, "point") + (duplicates > 0 ? " (" + counted(duplicates, "duplicate") + ")" : "");
}

}  // namespace rbpa::app
