// What: parses the arguments that several verbs share. Each parse_…() throws WrongUsage that names the value.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/mesh/single_precision.h"
#include "io/point_columns.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa::app {

/// The options that remove small holes and parts of outlines, as text.
struct AreaArguments {
  std::string min_hole_area = "0", min_part_area = "0";
};

/// Parses both limits of areas: numbers >= 0, or "inf".
PolygonFilter parse_areas(const AreaArguments& arguments);

/// Parses ascending radii above 0 with commas between them. `or_else` names in messages what else `option` accepts.
std::vector<double> parse_ascending(const std::string& option, const std::string& text, const std::string& or_else);

/// Parses --width, the width of a picture in pixels, from least_width to greatest_width (picture/scene.h).
int parse_width(const std::string& text);

/// Parses --complex. Returns false for "solid" and true for "full".
bool parse_is_full(const std::string& complex);

/// A file to write.
struct Target {
  std::string path;
  Format format;
};

/// The options about the run, which do not change the result, as text.
struct RunArguments {
  std::optional<std::string> threads;
  bool quiet = false;
  std::optional<std::string> stats;  ///< path of a file for the report
};

/// The options about output files and the run, as text.
struct OutputArguments {
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::string width = "1200";  ///< width of pictures, in pixels
  RunArguments run;
};

/// Paths of files that are written if they are given.
using Reports = std::vector<std::optional<std::string>>;
/// Returns the report of --json, standard output, or none.
inline std::optional<std::string> json_report(bool json) {
  return json ? std::optional<std::string>("-") : std::nullopt;
}
/// Returns the paths that are given.
std::vector<std::string> given(const Reports& reports);

/// Returns the files to write. The ending of a path gives its format; if it is unknown, --output-format does. For the
/// full complex m.npy becomes three targets: m.npy, m.edges.npy, m.points.npy. At least one target is required unless
/// a report is given: that of --stats, or one of `reports`. Throws WrongUsage, also if two of the targets, `input` and
/// the reports are one file; Failure if a file cannot be written (require_different()).
/// Requires: `use` is triangles, surface, solid or shape.
std::vector<Target> parse_targets(Use use, const OutputArguments& arguments, const std::string& input,
                                  Reports reports = {}, ComplexKind complex = ComplexKind::solid);

/// An input that an option names, and what it has, for messages.
struct SecondInput {
  std::string option, path, content;
};
/// An input that an argument names.
struct FirstInput {
  std::string argument, path;
};
/// Checks a second input. Throws WrongUsage if both inputs are standard input, or if a target or the report of --stats
/// is the second input; Failure as parse_targets() does.
void check_second_input(const SecondInput& second, const FirstInput& first, const std::vector<Target>& targets,
                        const OutputArguments& outputs);

/// Returns whether fits() is true for the format of any target.
bool any_of(const std::vector<Target>& targets, bool (*fits)(Format));
/// Returns whether any target has vertices with coordinates, that is, is neither a picture nor an array of indices.
bool any_has_vertices(const std::vector<Target>& targets);

/// Returns the paths of the files that GDAL writes for a target, in the order of ogr_endings(). The target itself is
/// first.
std::vector<std::string> ogr_paths(const Target& target);

/// Parse --fields. Without it, all fields are kept if any file holds fields, otherwise none. Throw WrongUsage if fields
/// are requested and no file holds fields; `required` describes a file that does. Of meshes PLY and VTU hold fields.
std::optional<FieldChoice> parse_fields_of(const std::optional<std::string>& text, bool any_holds,
                                           const std::string& required);
std::optional<FieldChoice> parse_fields_of(const std::optional<std::string>& text, const std::vector<Target>& meshes);

/// Returns a warning for each target and each column of 64-bit integers that the target cannot hold.
std::vector<std::string> fields_left_out(const std::vector<PointColumn>& columns, const std::vector<Target>& targets);

/// Parses --shift; returns nothing if it is not given. Throws WrongUsage unless a target is in single precision.
std::optional<Shift> parse_shift_of(const std::optional<std::string>& text, const std::vector<Target>& targets);

/// Returns the file that `option` names, with its format given by the ending; - is csv if `use` has tables. Throws
/// WrongUsage unless the format belongs to `use` and fits() is true for it.
Target target_of(const std::string& option, const std::string& path, Use use, bool (*fits)(Format) = nullptr);

/// Returns the format of an input: that of --format, otherwise that of the ending; for standard input without --format,
/// Format::by_content. `argument` names the input in messages.
Format parse_format(Use use, const std::string& path, const std::optional<std::string>& format,
                    const std::string& argument);

/// Return the name of an input or an output for messages. "-" is standard input or output.
inline std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }
inline std::string output_name(const std::string& path) { return path == "-" ? "standard output" : path; }

/// Returns " -> a.off, standard output"; "" if there are no paths.
std::string list_of(const std::vector<std::string>& paths);
template <typename Target>
std::string list_of(const std::vector<Target>& targets) {
  std::vector<std::string> paths;
  for (const Target& target : targets) paths.push_back(target.path);
  return list_of(paths);
}

/// Returns a text such as "2 polygons with 1 hole".
std::string text_of_polygons(std::size_t polygons, std::size_t holes);
/// Returns a text such as "5 points (1 duplicate)".
std::string text_of_points(std::size_t points, std::size_t duplicates);

}  // namespace rbpa::app
