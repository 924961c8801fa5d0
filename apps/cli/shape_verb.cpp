#include "cli/shape_verb.h"

#include <cstdio>
#include <utility>

#include "cli/arguments.h"
#include "cli/progress.h"
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

void write_targets(OutputSet& outputs, const std::vector<ShapeTarget>& targets, const ComplexRun& run,
                   const std::vector<Polygon>& shape, const SolidAlphaComplex& complex) {
  const ProgressLine line("rbpa", run.request.shows_writing, "writing");
  std::optional<Drawing> drawing;
  for (const ShapeTarget& target : targets) {
    stop_if_interrupted();
    OutputFile& file = outputs.add(target.path);
    switch (target.format) {
      case ShapeFormat::geojson:
        write_geojson(file, shape, run.points);
        break;
      case ShapeFormat::wkt:
        write_wkt(file, shape, run.points);
        break;
      case ShapeFormat::svg:
      case ShapeFormat::png:
        if (!drawing) drawing = drawing_of(run.points, shape, complex.isolated);
        const Scene scene = place(*drawing, run.request.width);
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

std::string made(const std::vector<Polygon>& shape, const PolygonTotals& totals) {
  char area[32];
  std::snprintf(area, sizeof area, "%.6g", totals.area);
  return counted(shape.size(), "polygon") + " with " + counted(totals.holes, "hole") + ", area " + area;
}

}  // namespace

void run_shape(const ShapeArguments& arguments) {
  ComplexRequest request = parse_request(arguments);
  const PolygonFilter filter{.min_hole_area = parse_area("--min-hole-area", arguments.min_hole_area),
                             .min_part_area = parse_area("--min-part-area", arguments.min_part_area)};
  const std::vector<ShapeTarget> targets =
      parse_shape_targets(arguments.outputs, arguments.output_format, given({arguments.stats}), arguments.points);

  ComplexRun run = begin_run(std::move(request));
  const SolidAlphaComplex complex = build(run.points, run.alpha, run.request.method, run.request.options).complex;
  stop_if_interrupted();
  const std::vector<Polygon> shape = outlined(complex, filter, run.request.options);
  const PolygonTotals totals = total(shape);
  run.stats.build_seconds = run.watch.lap();

  OutputSet outputs;
  write_targets(outputs, targets, run, shape, complex);
  run.stats.write_seconds = run.watch.lap();
  if (run.request.stats) {
    run.stats.distinct = complex.distinct;
    run.stats.isolated = complex.isolated.size();
    run.stats.counts = count(complex);
    run.stats.polygons = shape.size();
    run.stats.of_polygons = totals;
  }
  end_run(run, outputs);

  if (shape.empty())
    say("rbpa",
        "the shape is empty: " + (complex.mesh.n_faces() == 0 ? why_empty(run, complex.distinct)
                                                              : "no part has an area >= " + arguments.min_part_area));
  say_summary(run, complex.duplicates.size(), made(shape, totals), list_of(targets));
}

}  // namespace rbpa::app
