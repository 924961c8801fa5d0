#include "cli/arguments.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

bool is_regular_file(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

/// Whether two paths are, or will be, the same file. Devices may be shared.
bool same_file(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return a == b;
  std::error_code error;
  if (is_regular_file(a) && is_regular_file(b)) return std::filesystem::equivalent(a, b, error) && !error;
  if (std::filesystem::exists(a, error) || std::filesystem::exists(b, error)) return false;
  const auto full = [&](const std::string& path) { return std::filesystem::weakly_canonical(path, error); };
  return full(a) == full(b);
}

}  // namespace

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
    if (!known)
      throw WrongUsage("--format: found " + in_quotes(*format) + ", expected one of " + std::string(point_formats));
    source.format = *known;
  } else if (path != "-") {
    const std::optional<PointFormat> known = point_format(ending(path));
    if (!known)
      throw WrongUsage(path + ": found the ending " + in_quotes(ending(path)) + ", expected one of " +
                       std::string(point_formats) + ", or --format");
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
    if (!otherwise)
      throw WrongUsage("--output-format: found " + in_quotes(*format) + ", expected one of " +
                       std::string(output_formats));
  }
  if (paths.empty() && !stats) throw WrongUsage("found no -o OUT, expected at least one (or --stats)");
  std::vector<Target> targets;
  for (const std::string& path : paths) {
    std::optional<OutputFormat> known = path == "-" ? std::nullopt : output_format(ending(path));
    if (!known) known = otherwise;
    if (!known && path == "-")
      throw WrongUsage("-o -: found no --output-format, expected one of " + std::string(output_formats));
    if (!known)
      throw WrongUsage(path + ": found the ending " + in_quotes(ending(path)) + ", expected one of " +
                       std::string(output_formats) + ", or --output-format");
    targets.push_back({path, *known});
  }

  std::vector<std::string> files = paths;
  if (stats) files.push_back(*stats);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (points != "-" && same_file(files[i], points))
      throw WrongUsage(files[i] + ": found the file of points, expected another file to write to");
    for (std::size_t k = 0; k < i; ++k)
      if (same_file(files[i], files[k]))
        throw WrongUsage(files[i] + ": found twice among the files to write, expected once");
  }
  return targets;
}

}  // namespace rbpa::app
