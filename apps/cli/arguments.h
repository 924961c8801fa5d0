// What: the arguments that several verbs share, from text to meaning. Each throws WrongUsage naming the value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/formats.h"
#include "rbpa/triangulate.h"

namespace rbpa::app {

/// A bound on areas: a number >= 0, or "inf".
double parse_area(const std::string& option, const std::string& text);

/// Pixels that a picture can be wide.
int parse_width(const std::string& text);

/// "solid" or "full".
bool parse_is_full(const std::string& complex);

/// A file to write.
struct Target {
  std::string path;
  Format format;
};

/// Those that the command line names.
std::vector<std::string> given(const std::vector<std::optional<std::string>>& reports);

/// Formats by the endings; one without a known ending takes `format`. No two targets may be the same file, nor the
/// points or `reports`. Of the full complex m.npy is three targets: m.npy, m.edges.npy, m.points.npy.
std::vector<Target> parse_targets(const std::vector<std::string>& paths, const std::optional<std::string>& format,
                                  const std::vector<std::string>& reports, const std::string& points, Complex complex);
std::vector<Target> parse_shape_targets(const std::vector<std::string>& paths, const std::optional<std::string>& format,
                                        const std::vector<std::string>& reports, const std::string& points);

/// Of surfaces none is needed where there are `reports`.
std::vector<Target> parse_surface_targets(const std::vector<std::string>& paths,
                                          const std::optional<std::string>& format,
                                          const std::vector<std::string>& reports, const std::string& points);

/// The files of a target of GDAL, in the order of their endings.
std::vector<std::string> ogr_paths(const Target& target);

/// A file for the points in no polygon, by its ending.
Target parse_isolated(const std::string& path);

/// " -> a.off, standard output"; "" when there is none.
template <typename Target>
std::string list_of(const std::vector<Target>& targets) {
  std::string text;
  const char* before = " -> ";
  for (const Target& target : targets) {
    text += before + (target.path == "-" ? std::string("standard output") : target.path);
    before = ", ";
  }
  return text;
}

}  // namespace rbpa::app
