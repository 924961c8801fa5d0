#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/arguments.h"
#include "cli/complex_run.h"
#include "cli/named_groups.h"
#include "cli/stats.h"
#include "cli/verbs.h"
#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/polygon/shape_files.h"
#include "picture/picture.h"
#include "rbpa/groups.h"
#include "rbpa/rbpa.h"

namespace rbpa::app {
namespace {

/// Throws WrongUsage for what is of one shape of all points.
void require_no_others(const ShapeArguments& arguments) {
  if (arguments.isolated) throw WrongUsage("--isolated: found groups as well, expected one of the two");
}

void require_formats(const std::vector<Target>& targets) {
  for (const Target& target : targets)
    if (target.format != Format::geojson && target.format != Format::csv && !is_picture(target.format))
      throw WrongUsage("--group-by: found " + output_name(target.path) + ", expected geojson, csv, svg or png");
}

/// How each group finds its radius; of the two it keeps spans.
GroupAlpha group_alpha(const AlphaChoice& choice, const NamedGroups& named) {
  GroupAlpha alpha;
  if (choice.rule == AlphaRule::given) alpha.given = {&choice.radius, 1};
  if (choice.rule == AlphaRule::column) alpha.given = named.radii;
  alpha.covering = {.share = choice.cover};
  if (choice.rule == AlphaRule::automatic) alpha.covering.max_components = choice.max_components;
  if (choice.rule == AlphaRule::plateau) alpha.plateau = choice.rank;
  return alpha;
}

/// Groups whose radius is none say why.
void explain_radii(const NamedGroups& named, GroupShapes& shapes) {
  if (named.radius_problems.empty()) return;
  for (GroupProblem& problem : shapes.problems)
    if (!named.radius_problems[problem.group].empty()) problem.what = named.radius_problems[problem.group];
}

void say_problems(const Run& run, const NamedGroups& named, const std::vector<GroupProblem>& problems) {
  if (problems.empty()) return;
  const GroupProblem& first = problems.front();
  run.remark(counted(problems.size(), "group") + " without a polygon: " +
             (problems.size() == 1 ? "" : "the first is ") + in_quotes(named.names[first.group]) + ", " + first.what);
}

}  // namespace

void run_group_shapes(const ShapeArguments& arguments) {
  require_no_others(arguments);
  const AlphaChoice choice = parse_alpha(arguments.radius, ChosenFor::groups);
  const std::optional<std::string> column =
      choice.rule == AlphaRule::column ? std::optional(choice.column) : std::nullopt;
  const GroupSources sources = parse_group_sources(arguments, arguments, column);
  const ComplexRequest request = parse_request(arguments, ChosenFor::groups);
  GroupShapesOptions options;
  options.filter = {.min_hole_area = parse_area("--min-hole-area", arguments.min_hole_area),
                    .min_part_area = parse_area("--min-part-area", arguments.min_part_area)};
  options.threads = request.options.threads;
  const std::vector<Target> targets = parse_targets(Use::shape, arguments, arguments.points, given({arguments.stats}));
  require_formats(targets);
  std::vector<std::string> outputs = given({arguments.stats});
  for (const Target& target : targets) outputs.push_back(target.path);
  require_different(outputs, sources);

  Run run(sources.files.size() == 1 ? arguments.points : counted(sources.files.size(), "file"), arguments.outputs,
          request.options);
  const NamedGroups named = read_groups(run, sources);
  const PointFile& file = named.file;
  Stats stats{.points = file.points.size(), .read_seconds = run.lap()};
  GroupShapes shapes;
  {
    const ProgressLine line = request.options.line("shapes of groups");
    options.go_on = [go_on = until_interrupted()](std::size_t) { return go_on(); };
    shapes = shapes_of_groups(file.points, named.groups, group_alpha(choice, named), options);
  }
  explain_radii(named, shapes);
  stats.build_seconds = run.lap();
  std::vector<std::size_t> sizes;
  for (std::size_t g = 0; g < named.groups.size(); ++g) sizes.push_back(named.groups[g].size());
  const NamedShapes result{file.points, named.names, named.are_numbers, sizes, shapes, file.crs};
  {
    const ProgressLine line = run.writing();
    run.add(targets, [&](OutputFile& out, const Target& target) {
      if (target.format == Format::geojson)
        write_groups_geojson(out, result);
      else if (target.format == Format::csv)
        write_groups_csv(out, result);
      else
        write_picture(out, target.format, drawing_of(file.points, shapes.polygons, {}), request.width);
    });
  }
  if (arguments.stats) {
    stats.write_seconds = run.lap();
    stats.threads = threads_used(file.points.size(), request.options.threads);
    stats.alpha_rule = name_of(choice);
    if (choice.rule == AlphaRule::given) stats.alpha = choice.radius;
    stats.groups = GroupStats{named.names.size(), shapes.problems.size(), shapes.triangle_begin.back()};
    stats.polygons = shapes.polygons.size();
    stats.of_polygons = total(shapes.polygons);
    run.add(*arguments.stats, [&](OutputFile& out) { write_stats(out, stats); });
  }
  run.publish();

  const auto with_geojson = std::find_if(targets.begin(), targets.end(),
                                         [](const Target& target) { return target.format == Format::geojson; });
  if (with_geojson != targets.end())
    if (const auto why = geojson_caution({file.points, shapes.polygons, {}, file.crs, file.degrees}))
      say("rbpa", output_name(with_geojson->path) + ": " + *why);
  say_problems(run, named, shapes.problems);
  run.summarize(counted(file.points.size(), "point") + ", " + counted(named.names.size(), "group") + ", " +
                counted(shapes.polygons.size(), "polygon") + ", area " + rounded(total(shapes.polygons).area, 6) +
                list_of(targets));
}

}  // namespace rbpa::app
