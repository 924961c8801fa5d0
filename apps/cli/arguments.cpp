#include "cli/arguments.h"

#include <cmath>
#include <limits>

#include "io/failure.h"
#include "io/number.h"
#include "io/same_file.h"

namespace rbpa::app {
double parse_alpha(const std::string& text) {
  const ParsedNumber number = parse_whole_number(text);
  const bool infinite = number.fault == NumberFault::not_finite && number.value > 0;
  if (infinite) return std::numeric_limits<double>::infinity();
  if (number.fault != NumberFault::none || !(number.value > 0))
    throw WrongUsage("--alpha: found " + in_quotes(text) + ", expected a radius: a number > 0, or inf");
  return number.value;
}

PointSource parse_source(const std::string& path, const std::optional<std::string>& format,
                         const std::optional<std::string>& columns) {
  PointSource source{.path = path};
  if (columns) source.columns = parse_columns(*columns);
  if (format) {
    const std::optional<PointFormat> known = point_format(*format);
    if (!known) refuse_name("--format", *format, point_formats);
    source.format = *known;
  } else if (path != "-") {
    const std::optional<PointFormat> known = point_format(ending(path));
    if (!known) refuse_ending(path, point_formats, "--format");
    source.format = *known;
  }
  if (columns && source.format != PointFormat::text)
    throw WrongUsage("--columns: found a format with fixed columns, expected text");
  return source;
}

std::vector<Target> parse_targets(const std::vector<std::string>& paths, const std::optional<std::string>& format,
                                  const std::optional<std::string>& stats, const std::string& points) {
  std::optional<OutputFormat> otherwise;
  if (format) {
    otherwise = output_format(*format);
    if (!otherwise) refuse_name("--output-format", *format, output_formats);
  }
  if (paths.empty() && !stats) throw WrongUsage("found no -o OUT, expected at least one (or --stats)");
  std::vector<Target> targets;
  for (const std::string& path : paths) {
    std::optional<OutputFormat> known = path == "-" ? std::nullopt : output_format(ending(path));
    if (!known) known = otherwise;
    if (!known && path == "-")
      throw WrongUsage("-o -: found no --output-format, expected one of " + std::string(output_formats));
    if (!known) refuse_ending(path, output_formats, "--output-format");
    targets.push_back({path, *known});
  }

  std::vector<std::string> files = paths;
  if (stats) files.push_back(*stats);
  require_different(files, points, "points");
  return targets;
}

}  // namespace rbpa::app
