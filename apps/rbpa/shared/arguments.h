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

namespace rbpa::app {

/// Parses a bound on areas: a number >= 0, or "inf".
double parse_area(const std::string& option, const std::string& text);

/// Parses radii above 0, ascending, with commas between them. `or_else` tells in messages what else the option accepts.
std::vector<double> parse_ascending(const std::string& option, const std::string& text, const std::string& or_else);

/// Parses --width, the width of a picture in pixels: from least_width to greatest_width (picture/scene.h).
int parse_width(const std::string& text);

/// Parses --complex: "solid" (returns false) or "full" (returns true).
bool parse_is_full(const std::string& complex);

/// A file to write.
struct Target {
  std::string path;
  Format format;
};

/// The options about the files to write, as text.
struct OutputArguments {
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> stats;
};

/// Returns the paths that are present.
std::vector<std::string> given(const std::vector<std::optional<std::string>>& reports);

/// Returns the files to write; the format of each is that of its ending, else that of --output-format. For the full
/// complex m.npy becomes three targets: m.npy, m.edges.npy, m.points.npy. At least one target is required unless there
/// are `reports`. Throws WrongUsage, also if two of the targets, `input` and `reports` are the same file; Failure if a
/// file cannot be written there (require_different()).
/// Requires: `use` is triangles, surface, solid or shape.
std::vector<Target> parse_targets(Use use, const OutputArguments& arguments, const std::string& input,
                                  const std::vector<std::string>& reports, ComplexKind complex = ComplexKind::solid);

/// Returns whether fits() is true for the format of any target.
bool any_of(const std::vector<Target>& targets, bool (*fits)(Format));
/// Returns whether any target has vertices with coordinates: it is neither a picture nor an array of indices.
bool any_has_vertices(const std::vector<Target>& targets);

/// Returns the paths of the files that GDAL writes for a target, in the order of ogr_endings(): the target itself
/// first.
std::vector<std::string> ogr_paths(const Target& target);

/// Parse --fields; by default all fields are kept if any file holds them, otherwise none. Throw WrongUsage if fields
/// are requested, and no file holds them; `required` describes one that does. Of meshes those in PLY and VTU do.
std::optional<FieldChoice> parse_fields_of(const std::optional<std::string>& text, bool any_holds,
                                           const std::string& required);
std::optional<FieldChoice> parse_fields_of(const std::optional<std::string>& text, const std::vector<Target>& meshes);

/// Returns, for warnings, the 64-bit integers of `columns` that a target cannot hold; empty if it holds all.
std::vector<std::string> fields_left_out(const std::vector<PointColumn>& columns, const std::vector<Target>& targets);

/// Parses --shift; nothing if it is absent. Throws WrongUsage unless a target is in single precision.
std::optional<Shift> parse_shift_of(const std::optional<std::string>& text, const std::vector<Target>& targets);

/// Returns the file that `option` names, with its format by the ending: a format of `use`, for which fits() is true.
Target target_of(const std::string& option, const std::string& path, Use use, bool (*fits)(Format) = nullptr);

/// Returns the format of an input: that of --format, else that of the ending; for standard input without --format,
/// Format::by_content. `argument` names the input in messages.
Format parse_format(Use use, const std::string& path, const std::optional<std::string>& format,
                    const std::string& argument);

/// Return the name of an input, or of an output, for messages: "-" is a standard stream.
inline std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }
inline std::string output_name(const std::string& path) { return path == "-" ? "standard output" : path; }

/// Returns " -> a.off, standard output"; "" without paths.
std::string list_of(const std::vector<std::string>& paths);
template <typename Target>
std::string list_of(const std::vector<Target>& targets) {
  std::vector<std::string> paths;
  for (const Target& target : targets) paths.push_back(target.path);
  return list_of(paths);
}

/// Returns "2 polygons with 1 hole".
std::string text_of_polygons(std::size_t polygons, std::size_t holes);
/// Returns "5 points (1 duplicate)".
std::string text_of_points(std::size_t points, std::size_t duplicates);

}  // namespace rbpa::app
