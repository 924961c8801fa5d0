#include "cli/arguments.h"

#include <cmath>
#include <limits>

#include "io/failure.h"
#include "io/number.h"
#include "io/same_file.h"
#include "io/whole_number.h"
#include "picture/scene.h"

namespace rbpa::app {
namespace {

template <typename Format>
std::vector<TargetOf<Format>> targets_of(std::optional<Format> (&known_format)(std::string_view),
                                         std::string_view known_formats, const std::vector<std::string>& paths,
                                         const std::optional<std::string>& format,
                                         const std::vector<std::string>& reports, const std::string& points) {
  std::optional<Format> otherwise;
  if (format) {
    otherwise = known_format(*format);
    if (!otherwise) refuse_name("--output-format", *format, known_formats);
  }
  if (paths.empty() && reports.empty()) throw WrongUsage("found no -o OUT, expected at least one (or --stats)");
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

  std::vector<std::string> files = paths;
  files.insert(files.end(), reports.begin(), reports.end());
  require_different(files, points, "points");
  return targets;
}

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

PointSource parse_source(const std::string& path, const std::optional<std::string>& format,
                         const std::optional<std::string>& columns, const PixelArguments& pixels) {
  PointSource source{.path = path, .pixels = parse_pixel_rule(pixels)};
  if (path.empty()) throw WrongUsage("POINTS: found an empty name, expected a path or -");
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
  const bool is_image = source.format == PointFormat::png || source.format == PointFormat::pgm;
  if ((pixels.foreground || pixels.threshold) && !is_image)
    throw WrongUsage(std::string(pixels.foreground ? "--foreground" : "--threshold") +
                     ": found a format without pixels, expected png or pgm");
  return source;
}

std::vector<Target> parse_targets(const std::vector<std::string>& paths, const std::optional<std::string>& format,
                                  const std::vector<std::string>& reports, const std::string& points) {
  return targets_of(output_format, output_formats, paths, format, reports, points);
}

std::vector<ShapeTarget> parse_shape_targets(const std::vector<std::string>& paths,
                                             const std::optional<std::string>& format,
                                             const std::vector<std::string>& reports, const std::string& points) {
  return targets_of(shape_format, shape_formats, paths, format, reports, points);
}

}  // namespace rbpa::app
