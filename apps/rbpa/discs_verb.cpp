#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/write_shapes.h"
#include "io/sort.h"
#include "plane/shape_outputs.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/space/balls/measure_discs.h"
#include "shared/arguments.h"
#include "shared/stats.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

constexpr std::string_view column_prefix = "column:";

struct DiscsRequest {
  PointSource source;
  std::optional<std::string> column = std::nullopt;  ///< name of the column of radii
  double radius = 0;                                 ///< otherwise, the radius of all discs
  unsigned corners = 0;
  int width = 0;
  std::vector<Target> targets = {};
  RunOptions run = {};
};

DiscsRequest parse(const DiscsArguments& arguments) {
  DiscsRequest request{.source = parse_source(arguments)};
  request.run = parse_run(arguments.run);
  if (arguments.radius.starts_with(column_prefix) && arguments.radius.size() > column_prefix.size()) {
    request.column = arguments.radius.substr(column_prefix.size());
    request.source.keeps = FieldChoice{{{"", *request.column}}};  // optional: radii_of() reports what is missing
  } else {
    request.radius = parse_real("--radius", arguments.radius, {}, "a number, at least 0, or column:NAME");
  }
  request.corners =
      static_cast<unsigned>(parse_whole("--corners", arguments.corners, {.least = 3, .greatest = 100'000}, "corners"));
  request.width = parse_width(arguments.width);
  request.targets = parse_targets(Use::shape, arguments, arguments.points);
  return request;
}

std::vector<double> radii_of(const DiscsRequest& request, PointFile& file, const std::string& input) {
  if (!request.column) return std::vector<double>(file.points.size(), request.radius);
  PointColumn column = require_column(file.kept, *request.column, "--radius", input);
  if (column.is_text || !become_numbers(column))
    bad_input(input, "texts in column " + in_quotes(*request.column), "radii");
  std::vector<double> radii;
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (column.is_missing(i))
      bad_input(input, "point " + std::to_string(i) + " without a value of " + in_quotes(*request.column), "a radius");
    radii.push_back(column.value<double>(i));
  }
  return radii;
}

std::size_t number_of_distinct(std::vector<Point> points) {
  sort(points);
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

PointColumn column_of(std::string name, const std::vector<double>& values) {
  PointColumn column{.name = std::move(name)};
  for (const double value : values) column.append(value);
  return column;
}

}  // namespace

void run_discs(const DiscsArguments& arguments) {
  const DiscsRequest request = parse(arguments);
  Run run(arguments.points, arguments.outputs, request.run);
  Stats stats{.threads = run.options().threads_or_all()};
  PointFile file = run.read_points(request.source);
  require_srid(request.targets, file.crs);
  const std::vector<double> radii = radii_of(request, file, run.input());
  stats.points = file.points.size();
  if (!request.run.quiet || arguments.run.stats) stats.distinct = number_of_distinct(file.points);
  stats.read_seconds = run.lap();
  DiscMeasures measures;
  DiscPolygons made;
  try {
    const ProgressLine line = run.options().line("discs");
    measures =
        measure_discs(file.points, radii,
                      {.threads = run.options().threads, .progress = [](const Progress&) { return !interrupted(); }});
    made = disc_polygons(measures, file.points, radii, request.corners, until_interrupted());
  } catch (const InvalidInput& e) {
    throw BadInput(run.input() + ": " + e.what());
  }
  stats.build_seconds = run.lap();
  std::vector<std::optional<std::uint32_t>> polygon_of(radii.size());
  std::vector<std::uint32_t> isolated;  // discs of radius 0 that are alone: they have no polygon
  const std::vector<std::uint32_t>& with_polygon = made.components;  // ascending
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const auto found = std::lower_bound(with_polygon.begin(), with_polygon.end(), measures.components[i]);
    if (found != with_polygon.end() && *found == measures.components[i])
      polygon_of[i] = static_cast<std::uint32_t>(found - with_polygon.begin());
    else if (measures.components[i] != DiscMeasures::none)
      isolated.push_back(static_cast<std::uint32_t>(i));
  }
  const std::vector<PointColumn> columns = {column_of("radius", radii), column_of("area", measures.areas),
                                            column_of("length", measures.lengths)};
  const std::vector<Point> points = with_corners(std::move(file.points), made.points, made.polygons);
  const Shape shape{points, made.polygons, polygon_of, file.crs, file.degrees, file.index, columns};
  {
    const ProgressLine line = run.writing();
    add_shapes(run, request.targets, shape, isolated, request.width);
  }
  stats.write_seconds = run.lap();
  const PolygonTotals totals = total(made.polygons);
  if (arguments.run.stats) {
    stats.polygons = made.polygons.size();
    stats.of_polygons = {totals.holes, measures.area, measures.length};
    run.add_stats([&](OutputFile& output) { write_stats(output, stats); });
  }
  run.publish();
  caution(request.targets, shape);
  run.summarize(text_of_points(stats.points, stats.points - stats.distinct) + ", " +
                text_of_polygons(made.polygons.size(), totals.holes) + ", area " + rounded(measures.area, 6) +
                ", boundary " + rounded(measures.length, 6) + run.list_of(request.targets));
}

}  // namespace rbpa::app
