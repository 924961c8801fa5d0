#include "cli/shape_verb.h"

#include <cstdio>
#include <limits>

#include "cli/alpha_choice.h"
#include "cli/arguments.h"
#include "cli/build.h"
#include "cli/method.h"
#include "cli/progress.h"
#include "cli/stats.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/message.h"
#include "io/output_file.h"
#include "io/write_polygons.h"
#include "picture/png.h"
#include "picture/svg.h"
#include "rbpa/shape/polygons.h"

namespace rbpa::app {
namespace {

void write_targets(OutputSet& outputs, const std::vector<ShapeTarget>& targets, const std::vector<Point>& points,
                   const std::vector<Polygon>& shape, const SolidAlphaComplex& complex, int width, bool shown) {
  const ProgressLine line("rbpa", shown, "writing");
  std::optional<Drawing> drawing;
  for (const ShapeTarget& target : targets) {
    stop_if_interrupted();
    OutputFile& file = outputs.add(target.path);
    switch (target.format) {
      case ShapeFormat::geojson:
        write_geojson(file, shape, points);
        break;
      case ShapeFormat::wkt:
        write_wkt(file, shape, points);
        break;
      case ShapeFormat::svg:
      case ShapeFormat::png:
        if (!drawing) drawing = drawing_of(points, shape, complex.isolated);
        const Scene scene = place(*drawing, width);
        target.format == ShapeFormat::svg ? write_svg(file, scene) : write_png(file, scene);
        break;
    }
    file.finish();
  }
}

std::vector<Polygon> outlined(const SolidAlphaComplex& complex, const PolygonFilter& filter, const RunOptions& run) {
  const ProgressLine line("rbpa", !run.quiet, "polygons");
  return polygons(complex, filter);
}

std::string reason_for_no_polygon(const std::vector<Point>& points, const SolidAlphaComplex& complex,
                                  const ShapeArguments& arguments) {
  if (complex.mesh.n_faces() == 0) return reason_for_empty(points, complex.distinct, arguments.alpha);
  return "no part has an area >= " + arguments.min_part_area;
}

std::string summary(std::size_t points, const SolidAlphaComplex& complex, std::size_t polygons,
                    const PolygonTotals& totals, const std::string& chosen_alpha,
                    const std::vector<ShapeTarget>& targets) {
  char area[32];
  std::snprintf(area, sizeof area, "%.6g", totals.area);
  std::string text = counted(points, "point");
  if (!complex.duplicates.empty()) text += " (" + counted(complex.duplicates.size(), "duplicate") + ")";
  return text + ", " + counted(polygons, "polygon") + " with " + counted(totals.holes, "hole") + ", area " + area +
         chosen_alpha + list_of(targets);
}

}  // namespace

void run_shape(const ShapeArguments& arguments) {
  const AlphaChoice choice = parse_alpha(arguments.alpha, arguments.components);
  const Method method = parse_method(arguments.method);
  const RunOptions run = parse_run(arguments.run);
  const PolygonFilter filter{.min_hole_area = parse_area("--min-hole-area", arguments.min_hole_area),
                             .min_part_area = parse_area("--min-part-area", arguments.min_part_area)};
  const PointSource source = parse_source(arguments.points, arguments.format, arguments.columns, arguments.pixels);
  std::vector<std::string> reports;
  if (arguments.stats) reports.push_back(*arguments.stats);
  const std::vector<ShapeTarget> targets =
      parse_shape_targets(arguments.outputs, arguments.output_format, reports, arguments.points);
  const int width = parse_width(arguments.width);

  Stats stats{.alpha_rule = name_of(choice.rule)};
  Stopwatch watch;
  const std::vector<Point> points = read(source, run.quiet);
  stats.read_seconds = watch.lap();
  stats.alpha = choose_alpha(choice, points, run);
  if (choice.rule != AlphaRule::given) stats.choose_seconds = watch.lap();
  // Points without such a radius have no triangle at any.
  const double alpha = stats.alpha.value_or(std::numeric_limits<double>::infinity());
  const SolidAlphaComplex complex = build(points, alpha, method, run).complex;
  stop_if_interrupted();
  const std::vector<Polygon> shape = outlined(complex, filter, run);
  const PolygonTotals totals = total(shape);
  stats.build_seconds = watch.lap();

  OutputSet outputs;
  write_targets(outputs, targets, points, shape, complex, width, !run.quiet && !written_to_terminal(arguments.outputs));
  stats.write_seconds = watch.lap();
  if (arguments.stats) {
    stats.points = points.size();
    stats.threads = threads_used(points.size(), run.threads);
    stats.distinct = complex.distinct;
    stats.isolated = complex.isolated.size();
    stats.counts = count(complex);
    stats.method = method.name();
    stats.polygons = shape.size();
    stats.of_polygons = totals;
    OutputFile& file = outputs.add(*arguments.stats);
    write_stats(file, stats);
    file.finish();
  }
  outputs.publish();

  if (shape.empty()) say("rbpa", "the shape is empty: " + reason_for_no_polygon(points, complex, arguments));
  if (!run.quiet) {
    const std::string chosen_alpha = said(choice, stats.alpha);
    say("rbpa", summary(points.size(), complex, shape.size(), totals, chosen_alpha, targets));
  }
}

}  // namespace rbpa::app
