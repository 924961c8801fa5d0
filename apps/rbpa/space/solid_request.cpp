#include "space/solid_request.h"

#include <cmath>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "picture/picture.h"
#include "shared/alpha_option.h"
#include "shared/progress.h"
#include "space/void_files.h"

namespace rbpa::app {
namespace {

bool is_table_of_voids(Format format) { return format == Format::csv || format == Format::json; }

/// Throws WrongUsage for options that cannot be combined with --box.
void check_box(const SolidArguments& arguments, const SolidRequest& request) {
  if (request.alpha.rule == AlphaRule::plateau)
    throw WrongUsage("--alpha plateau cannot be combined with --box (give a radius, auto or min)");
  refuse_given({{arguments.balls, "--balls"},
                {arguments.void_radii, "--void-radii"},
                {arguments.pockets.has_value(), "--pockets"},
                {arguments.voids_above.has_value(), "--voids-above"},
                {arguments.top.has_value(), "--top"}},
               "cannot be combined with --box");
  if (request.voids && !is_table_of_voids(request.voids->format))
    bad_usage("--voids", "the ending " + in_quotes(ending(request.voids->path)),
              "one of " + endings(Use::voids, is_table_of_voids) + " with --box, as periodic voids may be unbounded");
}

/// Parses --complex. The default is the full complex for --voids, --pockets and --box, as triangles without a
/// tetrahedron also stop a ball; otherwise the solid complex.
ComplexKind parse_walls(const SolidArguments& arguments) {
  const bool is_about_voids = arguments.voids || arguments.pockets || arguments.box;
  const bool is_full = arguments.complex ? parse_is_full(*arguments.complex) : is_about_voids;
  return is_full ? ComplexKind::full : ComplexKind::solid;
}

void parse_choice_of_voids(const SolidArguments& arguments, SolidRequest& request) {
  if (arguments.pockets) request.pockets = target_of("--pockets", *arguments.pockets, Use::voids, is_table_of_voids);
  if (arguments.void_radii && (!request.voids || !is_table_of_voids(request.voids->format)))
    throw WrongUsage("--void-radii requires --voids FILE with one of the endings " +
                     endings(Use::voids, is_table_of_voids));
  if (!request.voids && !request.pockets)
    refuse_given({{arguments.voids_above.has_value(), "--voids-above"}, {arguments.top.has_value(), "--top"}},
                 "requires --voids or --pockets");
  if (arguments.voids_above)
    request.voids_above = parse_real("--voids-above", *arguments.voids_above, {}, "a volume, at least 0");
  if (arguments.top) request.top = parse_whole("--top", *arguments.top, {.least = 1});
}

}  // namespace

SolidRequest parse(const SolidArguments& arguments) {
  const bool has_names = arguments.json || arguments.voids || arguments.pockets;
  SolidRequest request{
      .source = parse_space_source(arguments, has_names ? columns_of_names() : std::vector<WantedColumn>()),
      .alpha = parse_alpha({.alpha = arguments.alpha, .cover = arguments.cover}),
      .box = {},
      .targets = {},
      .boundary = {},
      .voids = {},
      .pockets = {},
      .walls = parse_walls(arguments),
      .width = parse_width(arguments.width),
      .run = parse_run(arguments.run)};
  if (arguments.balls && request.alpha.rule == AlphaRule::given && std::isinf(request.alpha.radius))
    throw WrongUsage("--balls requires a finite --alpha");
  if (arguments.boundary) request.boundary = target_of("--boundary", *arguments.boundary, Use::boundary);
  request.shift =
      parse_shift_of(arguments.shift, request.boundary ? std::vector{*request.boundary} : std::vector<Target>());
  const std::string of_voids(ending(arguments.voids.value_or("")));
  if (find_format(Use::lined, of_voids) && !find_format(Use::voids, of_voids))
    bad_usage("--voids", "the ending " + in_quotes(of_voids),
              one_of(endings(Use::voids)) + " (rbpa balls --voids writes ." + of_voids + ")");
  if (arguments.voids) request.voids = target_of("--voids", *arguments.voids, Use::voids);
  if (arguments.box) {
    const UnitCell box = parse_box(*arguments.box, request.source.format);
    if (!box.fault.empty()) bad_usage("--box", box.fault, "right angles (rbpa balls --box takes any)");
    request.box = box.sides.value_or(Point3());
    check_box(arguments, request);
  }
  parse_choice_of_voids(arguments, request);
  request.targets =
      parse_targets(Use::solid, arguments, arguments.points,
                    {arguments.boundary, arguments.voids, arguments.pockets, json_report(arguments.json)});
  std::vector<Target> meshes = request.targets;
  if (request.boundary) meshes.push_back(*request.boundary);
  if (!request.box)
    request.source.choice.keeps = parse_fields_of(arguments.fields, meshes);
  else if (arguments.fields)
    throw WrongUsage("--fields cannot be combined with --box");
  return request;
}

std::string text_of_progress(const Progress& progress, double seconds) {
  const auto done = static_cast<double>(progress.triangles);  // solid() reports finished points as `triangles`
  const std::string text = short_number(done) + " points";
  return seconds > 0 ? text + ", " + short_number(done / seconds) + "/s" : text;
}

std::string text_of(const AlphaChoice& alpha, double radius) {
  return "alpha " + (alpha.rule == AlphaRule::given ? "" : name_of(alpha) + " = ") + text_of(radius);
}

}  // namespace rbpa::app
