#include "space/surface_request.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "io/failure.h"
#include "io/number.h"
#include "shared/point_arguments.h"
#include "triangulation/choices.h"

namespace rbpa::app {
namespace {

std::optional<NormalSource> parse_normals(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  if (*text == "file") return NormalSource::given;
  if (*text == "estimate") return NormalSource::estimate;
  if (*text == "none") return NormalSource::none;
  bad_usage("--normals", in_quotes(*text), "file, estimate or none");
}

/// Parses --color. Returns true if colors show the confidence of normals.
bool parse_color(const std::optional<std::string>& text) {
  if (!text || *text == "points") return false;
  if (*text == "normals") return true;
  bad_usage("--color", in_quotes(*text), "points or normals");
}

std::optional<double> parse_outlier_factor(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  if (*text == "auto") return OutlierOptions{}.factor;
  return parse_real("--drop-outliers", *text, {.least = 1}, "a factor, >= 1, or auto");
}

std::optional<std::size_t> parse_scale_space(const SurfaceArguments& arguments) {
  if (!arguments.scale_space) {
    if (arguments.moved) throw WrongUsage("--moved requires --scale-space");
    return std::nullopt;
  }
  if (*arguments.scale_space == "auto") return 0;
  return parse_whole("--scale-space", *arguments.scale_space, {.least = 1, .greatest = 100}, "steps (or auto)");
}

/// A viewpoint of all points, or the names of three columns that have a viewpoint for each point.
struct Viewpoint {
  std::vector<Point3> place = {};
  std::vector<WantedColumn> columns = {};
};

Viewpoint parse_viewpoint(const std::optional<std::string>& text) {
  if (!text) return {};
  Viewpoint viewpoint;
  std::vector<double> at;
  const std::vector<std::string_view> parts = split_at_commas(*text);
  for (const std::string_view part : parts) {
    const ParsedNumber number = parse_whole_number(part);
    if (number.fault == NumberFault::none)
      at.push_back(number.value);
    else if (!part.empty() && std::none_of(viewpoint.columns.begin(), viewpoint.columns.end(),
                                           [&](const WantedColumn& column) { return column.name == part; }))
      viewpoint.columns.push_back({.name = std::string(part)});
  }
  if (parts.size() != 3 || (at.size() != 3 && viewpoint.columns.size() != 3))
    bad_usage("--viewpoint", in_quotes(*text), "three coordinates, such as 0,0,1.5, or three names of columns");
  if (at.size() == 3) viewpoint.place = {{at[0], at[1], at[2]}};
  return viewpoint;
}

double parse_max_radius(const SurfaceArguments& arguments) {
  if (!arguments.max_radius) return std::numeric_limits<double>::infinity();
  if (arguments.radius != "auto") throw WrongUsage("--max-radius applies only to --radius auto");
  return parse_real("--max-radius", *arguments.max_radius, above_0, "a radius: a number above 0");
}

}  // namespace

SurfaceRequest parse(const SurfaceArguments& arguments) {
  const Viewpoint viewpoint = parse_viewpoint(arguments.viewpoint);
  SurfaceRequest request{.source = parse_space_source(arguments, viewpoint.columns, "--viewpoint")};
  ReconstructionOptions& how = request.how;
  if (arguments.radius != "auto") how.radii = parse_ascending("--radius", arguments.radius, "auto");
  how.max_radius = parse_max_radius(arguments);
  if (arguments.neighbors)
    how.neighbors = parse_whole("--neighbors", *arguments.neighbors, {.least = 2, .greatest = 1000}, "points");
  how.viewpoints = viewpoint.place;
  how.source = parse_normals(arguments.normals);
  request.colors_normals = parse_color(arguments.color);
  how.outlier_factor = parse_outlier_factor(arguments.drop_outliers);
  how.scale_space = parse_scale_space(arguments);
  how.moved = arguments.moved;
  how.flip = arguments.flip;
  how.repairs = arguments.repairs;
  how.manifold = arguments.manifold;
  how.watertight = arguments.watertight;
  how.refine = arguments.refine;
  if (arguments.no_crossings && !arguments.faces) throw WrongUsage("--no-crossings requires --faces");
  if (arguments.faces) {
    how.decimation = parse_decimation("--faces", *arguments.faces);
    how.decimation->no_crossings = arguments.no_crossings;
  }
  request.width = parse_width(arguments.width);
  request.run = parse_run(arguments.run);
  if (how.source == NormalSource::none && how.radii.size() > 1)
    bad_usage("--radius", counted(how.radii.size(), "number") + " with --normals none", "one radius");
  if (arguments.holes)
    target_of("--holes", *arguments.holes, Use::polylines, [](Format format) { return format == Format::obj; });
  if (how.source == NormalSource::none)
    refuse_given({{arguments.holes.has_value(), "--holes"},
                  {arguments.fill_holes.has_value(), "--fill-holes"},
                  {arguments.repairs, "--suggest-repairs"}},
                 "cannot be combined with --normals none, whose triangles have no boundary");
  if (arguments.shell) {
    if (how.source != NormalSource::none) throw WrongUsage("--shell requires --normals none");
    how.components.shell = parse_shell(*arguments.shell);
  }
  if (how.source == NormalSource::none && (arguments.neighbors || arguments.viewpoint || arguments.flip))
    throw WrongUsage("--normals none cannot be combined with --neighbors, --viewpoint or --flip, which change normals");
  if (how.source == NormalSource::given && arguments.neighbors)
    throw WrongUsage("--neighbors requires --normals estimate");
  if (request.colors_normals && how.source && how.source != NormalSource::estimate)
    throw WrongUsage("--color normals requires --normals estimate");
  if (arguments.neighbors && !how.source) how.source = NormalSource::estimate;
  if (arguments.keep_largest) how.components.max_components = parse_keep_largest(*arguments.keep_largest);
  if (arguments.drop_small) parse_drop_small(*arguments.drop_small, how.components);
  if (arguments.fill_holes) {
    if (arguments.watertight)
      throw WrongUsage("--fill-holes cannot be combined with --watertight, which fills all holes");
    how.filled = parse_fill_holes(*arguments.fill_holes);
  }
  if (arguments.repairs && (arguments.fill_holes || arguments.watertight))
    throw WrongUsage(
        "--suggest-repairs cannot be combined with --fill-holes or --watertight, which close holes themselves");
  request.targets =
      parse_targets(Use::surface, arguments, arguments.points, {arguments.holes, json_report(arguments.json)});
  request.source.choice.needs_normals = how.source.value_or(NormalSource::given) == NormalSource::given;
  request.source.choice.keeps = parse_fields_of(arguments.fields, request.targets);
  request.shift = parse_shift_of(arguments.shift, request.targets);
  if (arguments.refine) {
    if (!how.filled && !how.watertight) throw WrongUsage("--refine requires --fill-holes or --watertight");
    for (const Target& target : request.targets)
      if (target.format == Format::npy)
        bad_usage("--refine", in_quotes(target.path) + ", whose rows are numbers of input points",
                  "a format with points");
  }
  return request;
}

}  // namespace rbpa::app
