#include "cli/surface_arguments.h"

#include <algorithm>

#include "cli/point_arguments.h"
#include "io/bytes/number.h"
#include "io/bytes/same_file.h"
#include "io/failure.h"

namespace rbpa::app {
namespace {

Format parse_format(const SurfaceArguments& arguments) {
  if (arguments.points.empty()) throw WrongUsage("POINTS: found an empty name, expected a path or -");
  if (arguments.format) {
    const std::optional<Format> known = find_format(Use::space, *arguments.format);
    if (!known) refuse_name("--format", *arguments.format, space_formats);
    return *known;
  }
  if (arguments.points == "-") return Format::text;
  const std::optional<Format> known = find_format(Use::space, input_ending(arguments.points));
  if (!known) refuse_input(arguments.points, space_formats, "--format");
  return *known;
}

std::vector<double> parse_radii(const std::string& text) {
  if (text == "auto") return {};
  std::vector<double> radii;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const ParsedNumber number = parse_whole_number(part);
    if (number.fault != NumberFault::none || !(number.value > 0))
      throw WrongUsage("--radius: found " + in_quotes(part) +
                       ", expected a radius: a number above 0, several with commas between them, or auto");
    if (!radii.empty() && number.value <= radii.back())
      throw WrongUsage("--radius: found " + in_quotes(part) + " behind " + std::string(ShortestText(radii.back())) +
                       ", expected ascending radii");
    radii.push_back(number.value);
    begin = end + 1;
  }
  return radii;
}

std::optional<NormalSource> parse_normals(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  if (*text == "file") return NormalSource::file;
  if (*text == "estimate") return NormalSource::estimate;
  if (*text == "none") return NormalSource::none;
  throw WrongUsage("--normals: found " + in_quotes(*text) + ", expected file, estimate or none");
}

}  // namespace

SurfaceRequest parse(const SurfaceArguments& arguments) {
  SurfaceRequest request{.path = arguments.points,
                         .format = parse_format(arguments),
                         .choice = {},
                         .radii = parse_radii(arguments.radius),
                         .normals = parse_normals(arguments.normals),
                         .targets = {},
                         .width = parse_width(arguments.width),
                         .run = parse_run(arguments.run)};
  const bool text = request.format == Format::text;
  if (arguments.columns) {
    require_format(text, "--columns", "with fixed columns", "text");
    request.choice.columns = parse_space_columns(*arguments.columns);
  }
  if (arguments.skip_invalid)
    require_format(text || request.format == Format::las, "--skip-invalid", "without lines of points", "las or text");
  request.choice.skip_invalid = arguments.skip_invalid;
  if (arguments.where) {
    const std::optional<FieldNames> names = fields_of(request.format);
    require_format(names.has_value(), "--where", "without fields beside the points", "las, pcd, ply or text");
    request.choice.where = Condition(*arguments.where, *names);
  }
  if (request.normals == NormalSource::none && request.radii.size() > 1)
    throw WrongUsage("--radius: found " + counted(request.radii.size(), "number") +
                     " with --normals none, expected one radius");
  if (arguments.holes) {
    if (find_format(Use::polylines, ending(*arguments.holes)) != Format::obj)
      throw WrongUsage("--holes: found the ending " + in_quotes(ending(*arguments.holes)) + ", expected obj");
    if (request.normals == NormalSource::none)
      throw WrongUsage("--holes: found --normals none, of which the triangles have no boundary");
  }
  std::vector<std::string> reports = given({arguments.stats, arguments.holes});
  if (arguments.json) reports.emplace_back("-");
  request.targets = parse_surface_targets(arguments.outputs, arguments.output_format, reports, arguments.points);
  return request;
}

}  // namespace rbpa::app
