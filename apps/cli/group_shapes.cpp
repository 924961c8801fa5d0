#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/complex_run.h"
#include "cli/verbs.h"
#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/polygon/shape_files.h"
#include "picture/picture.h"
#include "rbpa/groups.h"

namespace rbpa::app {
namespace {

/// The groups of a file, by their keys: numbers in their order, texts by their bytes.
struct NamedGroups {
  std::vector<std::string> names = {};
  bool are_numbers = false;
  Groups groups = {};
};

/// Of a format whose fields are numbers.
NamedGroups groups_by_number(const std::vector<double>& keys) {
  std::vector<double> values;
  for (const double key : keys)
    if (!std::isnan(key)) values.push_back(key + 0.0);  // zeros of both signs are one
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<std::uint32_t> labels;
  labels.reserve(keys.size());
  for (const double key : keys)
    labels.push_back(std::isnan(key) ? no_group
                                     : static_cast<std::uint32_t>(std::lower_bound(values.begin(), values.end(), key) -
                                                                  values.begin()));
  NamedGroups named{.are_numbers = true, .groups = groups_of(labels, values.size())};
  for (const double value : values) {
    named.names.push_back(text_of(value));
    named.are_numbers = named.are_numbers && std::isfinite(value);
  }
  return named;
}

/// Of a table, whose keys are texts; an empty one is none. Those of lines that do not count are left out.
NamedGroups groups_by_text(const std::vector<double>& keys, const std::vector<std::string>& texts) {
  std::vector<std::uint8_t> counts(texts.size(), 0);
  for (const double key : keys) counts[static_cast<std::size_t>(key)] = 1;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (counts[i] != 0 && !texts[i].empty()) order.push_back(i);
  std::vector<double> value(texts.size(), 0);
  bool are_numbers = true;
  for (const std::size_t i : order) {
    const ParsedNumber number = parse_whole_number(texts[i]);
    are_numbers = are_numbers && number.fault == NumberFault::none;
    value[i] = number.value;
  }
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return are_numbers && value[i] != value[j] ? value[i] < value[j] : texts[i] < texts[j];
  });
  std::vector<std::uint32_t> label(texts.size(), no_group), labels;
  NamedGroups named{.are_numbers = are_numbers};
  for (std::size_t k = 0; k < order.size(); ++k) {
    label[order[k]] = static_cast<std::uint32_t>(k);
    named.names.push_back(texts[order[k]]);
  }
  labels.reserve(keys.size());
  for (const double key : keys) labels.push_back(label[static_cast<std::size_t>(key)]);
  named.groups = groups_of(labels, order.size());
  return named;
}

NamedGroups groups_in(const PointFile& file) {
  if (file.fields.empty()) return {};  // no points
  return file.keys.empty() ? groups_by_number(file.fields[0]) : groups_by_text(file.fields[0], file.keys);
}

/// Throws WrongUsage for what is of one shape of all points.
void require_no_others(const ShapeArguments& arguments) {
  if (arguments.isolated) throw WrongUsage("--isolated: found --group-by as well, expected one of the two");
  if (arguments.stats) throw WrongUsage("--stats: found --group-by as well, expected one of the two");
}

void require_formats(const std::vector<Target>& targets) {
  for (const Target& target : targets)
    if (target.format != Format::geojson && target.format != Format::csv && !is_picture(target.format))
      throw WrongUsage("--group-by: found " + output_name(target.path) + ", expected geojson, csv, svg or png");
}

}  // namespace

void run_group_shapes(const ShapeArguments& arguments) {
  require_no_others(arguments);
  const ComplexRequest request = parse_request(arguments);
  GroupShapesOptions options;
  options.filter = {.min_hole_area = parse_area("--min-hole-area", arguments.min_hole_area),
                    .min_part_area = parse_area("--min-part-area", arguments.min_part_area)};
  options.threads = request.options.threads;
  const std::vector<Target> targets = parse_targets(Use::shape, arguments, arguments.points, {});
  require_formats(targets);

  Run run(request.source.path, arguments.outputs, request.options);
  const PointFile file = run.read_points(request.source);
  const NamedGroups named = groups_in(file);
  const double radius[] = {request.alpha.radius};
  GroupAlpha alpha;
  if (request.alpha.rule == AlphaRule::given) alpha.given = radius;
  alpha.covering = {.share = request.alpha.cover};
  if (request.alpha.rule == AlphaRule::automatic) alpha.covering.max_components = request.alpha.max_components;
  if (request.alpha.rule == AlphaRule::plateau) alpha.plateau = request.alpha.rank;
  GroupShapes shapes;
  {
    const ProgressLine line = request.options.line("shapes of groups");
    options.go_on = [go_on = until_interrupted()](std::size_t) { return go_on(); };
    shapes = shapes_of_groups(file.points, named.groups, alpha, options);
  }
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
  run.publish();

  const std::size_t left_out = file.points.size() - named.groups.members.size();
  if (left_out > 0) run.remark(counted(left_out, "point") + " without a group");
  const auto with_geojson = std::find_if(targets.begin(), targets.end(),
                                         [](const Target& target) { return target.format == Format::geojson; });
  if (with_geojson != targets.end())
    if (const auto why = geojson_caution({file.points, shapes.polygons, {}, file.crs, file.degrees}))
      say("rbpa", output_name(with_geojson->path) + ": " + *why);
  if (!shapes.problems.empty()) {
    const GroupProblem& first = shapes.problems.front();
    run.remark(counted(shapes.problems.size(), "group") +
               " without a polygon: " + (shapes.problems.size() == 1 ? "" : "the first is ") +
               in_quotes(named.names[first.group]) + ", " + first.what);
  }
  run.summarize(counted(file.points.size(), "point") + ", " + counted(named.names.size(), "group") + ", " +
                counted(shapes.polygons.size(), "polygon") + ", area " + rounded(total(shapes.polygons).area, 6) +
                list_of(targets));
}

}  // namespace rbpa::app
