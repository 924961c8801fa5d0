// What: the arguments that several verbs share, from text to meaning. Each throws WrongUsage naming the value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/formats.h"
#include "io/read_points.h"

namespace rbpa::app {

/// A radius: a number > 0, or "inf".
double parse_alpha(const std::string& text);

/// Where the points come from: the format as said, else by the ending; standard input is text.
PointSource parse_source(const std::string& path, const std::optional<std::string>& format,
                         const std::optional<std::string>& columns);

struct Target {
  std::string path;
  OutputFormat format;
};

/// Formats by the endings; one without a known ending takes `format`. No two targets may be the same file, nor the
/// points or `stats`.
std::vector<Target> parse_targets(const std::vector<std::string>& paths, const std::optional<std::string>& format,
                                  const std::optional<std::string>& stats, const std::string& points);

}  // namespace rbpa::app
