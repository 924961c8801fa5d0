#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/ogr.h"
#include "io/polygon/summaries.h"
#include "io/polygon/write_shapes.h"
#include "picture/picture.h"
#include "plane/shape_outputs.h"
#include "rbpa/plane/groups.h"
#include "rbpa/plane/link_triangles.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/polygon_of_points.h"
#include "shared/arguments.h"
#include "shared/complex_run.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

struct Files {
  std::vector<Target> targets;
  std::optional<Target> isolated = std::nullopt;  ///< file for the points in no polygon

  std::vector<Target> all() const {
    std::vector<Target> all = targets;
    if (isolated) all.push_back(*isolated);
    return all;
  }
  /// Returns whether any file lists points with their fields. A GeoPackage lists isolated points.
  bool have_fields() const {
    return (isolated && !is_text_geometry(isolated->format)) ||
           any_of(targets, [](Format format) { return format == Format::csv || format == Format::gpkg; });
  }
  /// Returns whether any file lists points: points of each polygon, or points in no polygon.
  bool have_points() const {
    return isolated || std::any_of(targets.begin(), targets.end(), [](const Target& target) {
             return !is_text_geometry(target.format) && !is_picture(target.format);
           });
  }
};

void write_isolated(OutputFile& file, Format format, const Shape& shape) {
  if (format == Format::geojson) return write_isolated_geojson(file, shape);
  if (format == Format::ewkt) file.write(srid_of(shape));
  is_text_geometry(format) ? write_isolated_wkt(file, shape) : write_isolated_csv(file, shape);
}

void write_files(ComplexRun& run, const Files& files, const Shape& shape, const AlphaComplex& complex) {
  const ProgressLine line = run.writing();
  add_shapes(run, files.targets, shape, complex.isolated, run.request.width);
  if (!files.isolated) return;
  const auto& [path, format] = *files.isolated;
  if (is_ogr(format)) return add_ogr(run, *files.isolated, ogr_isolated(format, shape));
  run.add(path, [&, format = format](OutputFile& file) { write_isolated(file, format, shape); });
}

/// Returns the peak memory of a run in bytes for each point, without the memory of the point itself. The numbers are
/// measured on millions of points: docs/explanation/plane.md, section 25.
double bytes_a_point(const ComplexRequest& request) {
  if (request.alpha.rule != AlphaRule::given) return 500;
  return request.method.by_paper ? 280 : 100;
}

}  // namespace

void run_shape(const ShapeArguments& arguments) {
  if (arguments.has_groups()) return run_group_shapes(arguments);
  ComplexRequest request = parse_request(arguments);
  request.bytes_a_point = bytes_a_point(request);
  const PolygonFilter filter = parse_areas(arguments);
  Files files{.targets = parse_targets(Use::shape, arguments, arguments.points, {arguments.isolated})};
  if (arguments.isolated) files.isolated = target_of("--isolated", *arguments.isolated, Use::isolated);
  const std::optional<FieldChoice> listed =
      parse_fields_of(arguments.fields, files.have_fields(), "a list of points in csv or gpkg, or --isolated");
  constexpr auto holds = [](Format format) { return format == Format::geojson || is_ogr(format); };
  const std::vector<SummaryChoice> summaries =
      parse_summaries(arguments.summarize, any_of(files.targets, holds), endings(Use::shape, holds));
  request.source.keeps = with_summaries(listed, summaries);

  request.check = [&](const PointFile& file) { require_srid(files.all(), file.crs); };

  ComplexRun run(request, arguments);
  std::vector<PointColumn>& columns = run.file.kept;  // listed columns first, then columns that are only summarized
  const auto end = std::stable_partition(columns.begin(), columns.end(),
                                         [&](const PointColumn& column) { return listed && listed->has(column.name); });
  AlphaComplex complex =
      build(run.points(), run.alpha, request.method, ComplexKind::solid, Links::none, run.options()).complex;
  // Link the finished triangles: this takes less memory than build() with Links::neighbors.
  complex.neighbors = link_triangles(complex.triangles, run.points().size(), until_interrupted());
  stop_if_interrupted();
  std::vector<Polygon> made;
  {
    const ProgressLine line = run.options().line("polygons");
    made = outline_polygons(run.points(), complex, filter, until_interrupted());
  }
  const PolygonTotals totals = total(made);
  std::vector<std::optional<std::uint32_t>> polygon_of;
  if (files.have_points() || !summaries.empty())
    polygon_of = polygon_of_points(run.points(), complex, complex.duplicates, made, filter, until_interrupted());
  Shape shape{run.points(), made, polygon_of, run.file.crs, run.file.degrees, run.file.index, {columns.begin(), end}};
  std::vector<Attribute> of_polygons;
  if (!summaries.empty()) {
    std::vector<std::uint32_t> labels;
    for (const std::optional<std::uint32_t>& polygon : polygon_of) labels.push_back(polygon.value_or(no_group));
    shape.summaries = of_polygons = summaries_of(summaries, columns, groups_of(labels, made.size()), run.input());
  }
  run.stats.build_seconds = run.lap();

  write_files(run, files, shape, complex);
  run.stats.write_seconds = run.lap();
  if (arguments.run.stats) {
    run.stats.distinct = complex.distinct;
    run.stats.isolated = complex.isolated.size();
    run.stats.counts = count(run.points(), complex, ComplexKind::solid, until_interrupted());
    run.stats.count_seconds = run.lap();
    run.stats.polygons = made.size();
    run.stats.of_polygons = totals;
  }
  run.finish();
  caution(files.all(), shape);

  if (made.empty())
    say("rbpa",
        "the shape is empty: " + (complex.triangles.empty() ? run.why_empty(complex.distinct)
                                                            : "no part has an area >= " + arguments.min_part_area));
  run.summarize(complex.duplicates.size(),
                text_of_polygons(made.size(), totals.holes) + ", area " + rounded(totals.area, 6),
                run.list_of(files.targets));
}

}  // namespace rbpa::app
