#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/ogr.h"
#include "io/polygon/summaries.h"
#include "io/polygon/write_shapes.h"
#include "picture/picture.h"
#include "plane/group_run.h"
#include "plane/shape_outputs.h"
#include "shared/arguments.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

bool has_groups(Format format) { return format != Format::wkt && format != Format::ewkt; }

/// Throws WrongUsage for an option or a format that does not apply to groups.
void require_of_groups(const ShapeArguments& arguments, const std::vector<Target>& targets) {
  refuse_given(
      {{arguments.isolated.has_value(), "--isolated"}, {arguments.fields.value_or("none") != "none", "--fields"}},
      not_with_groups);
  for (const Target& target : targets)
    if (!has_groups(target.format))
      bad_usage("--group-by", output_name(target.path) + ", whose format has no groups",
                "one of " + endings(Use::shape, has_groups));
}

void write_targets(GroupRun& run, const std::vector<Attribute>& summaries) {
  const ProgressLine line = run.writing();
  NamedShapes result = run.named_shapes();
  std::vector<std::string> taken;
  for (const Attribute& summary : summaries) taken.push_back(summary.name);
  std::vector<Attribute> attributes = key_attributes(run.named, std::move(taken));
  attributes.insert(attributes.end(), summaries.begin(), summaries.end());
  result.attributes = attributes;
  for (const Target& target : run.request.targets) {
    stop_if_interrupted();
    if (is_ogr(target.format)) {
      add_ogr(run, target, ogr_groups(target.format, result));
      if (const std::size_t none = run.shapes.problems.size(); none > 0 && target.format == Format::fgb)
        run.warning(output_name(target.path) + " leaves out " + counted(none, "group") +
                    " without a polygon: FlatGeobuf has no feature without a geometry");
      continue;
    }
    if (is_picture(target.format)) {
      const Drawing drawing = drawing_of(result.points, run.shapes.polygons, run.shapes.polygon_begin, result.names);
      add_picture(run, target, drawing, run.request.complex.width, result.crs);
      continue;
    }
    run.add(target.path, [&](OutputFile& out) {
      target.format == Format::geojson ? write_groups_geojson(out, result) : write_groups_csv(out, result);
    });
  }
}

void caution(const GroupRun& run) {
  const std::vector<Target>& targets = run.request.targets;
  const auto with_geojson = std::find_if(targets.begin(), targets.end(),
                                         [](const Target& target) { return target.format == Format::geojson; });
  if (with_geojson == targets.end()) return;
  const PointFile& file = run.named.file;
  if (const auto why = geojson_caution({file.points, run.shapes.polygons, {}, file.crs, file.degrees}))
    say("rbpa", output_name(with_geojson->path) + ": " + *why);
}

}  // namespace

void run_group_shapes(const ShapeArguments& arguments) {
  const std::vector<Target> targets = parse_targets(Use::shape, arguments, arguments.points);
  require_of_groups(arguments, targets);
  GroupRequest request = parse_group_request(arguments, targets);
  constexpr auto holds = [](Format format) { return has_groups(format) && !is_picture(format); };
  const std::vector<SummaryChoice> summaries =
      parse_summaries(arguments.summarize, any_of(targets, holds), endings(Use::shape, holds));
  for (PointSource& source : request.sources.files) source.keeps = with_summaries(std::nullopt, summaries);
  GroupShapesOptions options;
  options.filter = parse_areas(arguments);
  GroupRun run(request, arguments, options);
  write_targets(run, summaries_of(summaries, run.named.file.kept, run.named.groups, run.input()));
  run.finish();
  caution(run);
  run.summarize(counted(run.shapes.polygons.size(), "polygon") + ", area " +
                rounded(total(run.shapes.polygons).area, 6));
}

}  // namespace rbpa::app
