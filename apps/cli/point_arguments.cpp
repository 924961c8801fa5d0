#include "cli/point_arguments.h"

#include "io/failure.h"
#include "io/polygon/ogr.h"

namespace rbpa::app {
namespace {

Format parse_format_of_any(const std::string& path, const std::optional<std::string>& format) {
  if (format) {
    const std::optional<Format> known = find_format(Use::points, *format);
    if (!known) refuse_name("--format", *format, point_formats);
    return *known;
  }
  if (path == "-") return Format::text;
  const std::optional<Format> known = find_format(Use::points, input_ending(path));
  if (!known) refuse_input(path, point_formats, "--format");
  return *known;
}

/// Without GDAL its formats are none.
Format parse_format(const std::string& path, const std::optional<std::string>& format) {
  const Format known = parse_format_of_any(path, format);
  if (known != Format::ogr) return known;
  if (!has_gdal() && format) refuse_name("--format", *format, point_formats);
  if (!has_gdal()) refuse_input(path, point_formats, "--format");
  if (path == "-") throw WrongUsage("-: found standard input, expected the name of a file, which GDAL opens");
  return known;
}

}  // namespace

void require_format(bool fits, const std::string& option, const std::string& found, const std::string& expected) {
  if (!fits) throw WrongUsage(option + ": found a format " + found + ", expected " + expected);
}

PointSource parse_source(const PointArguments& arguments) {
  if (arguments.points.empty()) throw WrongUsage("POINTS: found an empty name, expected a path or -");
  PointSource source{.path = arguments.points,
                     .pixels = parse_pixel_rule(arguments.pixels),
                     .skip_invalid = arguments.skip_invalid,
                     .vertices = arguments.vertices,
                     .shift_longitude = arguments.shift_longitude};
  if (arguments.columns) source.columns = parse_columns(*arguments.columns);
  if (arguments.crs) source.crs = parse_crs(*arguments.crs);
  source.layer = arguments.layer;
  source.format = parse_format(arguments.points, arguments.format);

  const Format format = source.format;
  const bool text = format == Format::text, ogr = format == Format::ogr;
  if (arguments.columns) require_format(text, "--columns", "with fixed columns", "text");
  if (arguments.skip_invalid)
    require_format(text || format == Format::las, "--skip-invalid", "without lines of points", "las or text");
  if (arguments.where) {
    const std::optional<FieldNames> names = fields_of(format);
    require_format(names.has_value(), "--where", "without fields beside the points", "las, ply or text");
    source.where = Condition(*arguments.where, *names);
  }
  if (arguments.vertices)
    require_format(text || ogr || format == Format::wkt || format == Format::geojson, "--vertices",
                   "without lines and polygons", "geojson, wkt, or text with a column of it");
  if (arguments.layer) require_format(ogr, "--layer", "without layers", "one of GDAL");
  const bool image = format == Format::png || format == Format::pgm;
  if (arguments.pixels.foreground) require_format(image, "--foreground", "without pixels", "png or pgm");
  if (arguments.pixels.threshold) require_format(image, "--threshold", "without pixels", "png or pgm");
  return source;
}

}  // namespace rbpa::app
