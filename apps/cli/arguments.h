// What: the arguments that several verbs share, from text to meaning. Each throws WrongUsage naming the value.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/mesh/single_precision.h"
#include "rbpa/triangulate.h"

namespace rbpa::app {

/// A bound on areas: a number >= 0, or "inf".
double parse_area(const std::string& option, const std::string& text);

/// Radii above 0, ascending, with commas between them. `or_else` is what the option has otherwise. Throws WrongUsage.
std::vector<double> parse_ascending(const std::string& option, const std::string& text, const std::string& or_else);
/// Pixels that a picture can be wide.
int parse_width(const std::string& text);

/// "solid" or "full".
bool parse_is_full(const std::string& complex);

/// A file to write.
struct Target {
  std::string path;
  Format format;
};

/// What the command line says of files to write, as text.
struct OutputArguments {
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> stats;
};

/// Those that the command line names.
std::vector<std::string> given(const std::vector<std::optional<std::string>>& reports);

/// Formats by the endings; one without a known ending takes the output format. No two targets may be the same file, nor the
/// input or `reports`; where there are reports none is needed. Of the full complex m.npy is three targets: m.npy,
/// m.edges.npy, m.points.npy. Requires: triangles, surface, solid or shape.
std::vector<Target> parse_targets(Use use, const OutputArguments& arguments, const std::string& input,
                                  const std::vector<std::string>& reports, Complex complex = Complex::solid);

/// The formats of its targets, for help: with GDAL's where this program has them.
std::string target_formats(Use use);

/// Whether a target has vertices, with three coordinates: it is neither a picture nor an array of indices.
bool any_has_vertices(const std::vector<Target>& targets);

/// The files of a target of GDAL, in the order of their endings.
std::vector<std::string> ogr_paths(const Target& target);

/// Parses --shift. It applies where at least one target is in single precision.
std::optional<Shift> parse_shift_of(const std::optional<std::string>& text, const std::vector<Target>& targets);

/// A file for the points in no polygon, by its ending.
Target parse_isolated(const std::string& path);

/// The format of an input, as --format says it, else by the ending, or of standard input by its content. `known` are
/// those there are, and `argument` is what the command line calls the input.
Format parse_format(Use use, const std::string& path, const std::optional<std::string>& format, std::string_view known,
                    const std::string& argument);

/// What messages call an input and an output: "-" is a standard stream.
inline std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }
inline std::string output_name(const std::string& path) { return path == "-" ? "standard output" : path; }

/// " -> a.off, standard output"; "" when there is none.
std::string list_of(const std::vector<std::string>& paths);
template <typename Target>
std::string list_of(const std::vector<Target>& targets) {
  std::vector<std::string> paths;
  for (const Target& target : targets) paths.push_back(target.path);
  return list_of(paths);
}

/// "2 polygons with 1 hole".
std::string text_of_polygons(std::size_t polygons, std::size_t holes);
/// "5 points (1 duplicate)".
std::string text_of_points(std::size_t points, std::size_t duplicates);

}  // namespace rbpa::app
