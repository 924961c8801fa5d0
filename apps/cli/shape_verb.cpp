#include "cli/shape_verb.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/arguments.h"
#include "cli/build.h"
#include "cli/progress.h"
#include "io/bytes/output_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/polygon/ogr.h"
#include "io/polygon/shape_files.h"
#include "picture/png.h"
#include "picture/svg.h"
#include "rbpa/coverage.h"
#include "rbpa/link_triangles.h"
#include "rbpa/rbpa.h"
#include "rbpa/shape.h"
#include "triangulation/counts.h"

namespace rbpa::app {
namespace {

bool is_picture(Format format) { return format == Format::svg || format == Format::png; }

bool is_text_geometry(Format format) { return format == Format::wkt || format == Format::ewkt; }

/// What the command line asks for.
struct Files {
  std::vector<Target> targets;
  std::optional<Target> isolated = std::nullopt;  ///< for the points in no polygon

  /// Whether any of them says in which polygon points are.
  bool have_points() const {
    return isolated || std::any_of(targets.begin(), targets.end(), [](const Target& target) {
             return !is_text_geometry(target.format) && !is_picture(target.format);
           });
  }
};

/// What EWKT has before WKT. Requires: require_srid().
std::string srid_of(const Shape& shape) { return "SRID=" + *shape.crs->srid() + ";"; }

/// EWKT names the system, which is known when the points are read.
void require_srid(const Files& files, const std::optional<Crs>& crs) {
  std::vector<Target> all = files.targets;
  if (files.isolated) all.push_back(*files.isolated);
  const auto first = std::find_if(all.begin(), all.end(), [](const Target& t) { return t.format == Format::ewkt; });
  if (first == all.end() || (crs && crs->srid())) return;
  throw WrongUsage((first->path == "-" ? "-o -" : first->path) + ": found points in " +
                   (crs ? crs->text() : "a system that is not known") +
                   ", expected one with a number of EPSG, which EWKT names (--crs EPSG:28992, or the ending wkt)");
}

void write_shape(OutputFile& file, Format format, const Shape& shape) {
  if (format == Format::csv) return write_points_csv(file, shape);
  if (format == Format::ewkt) file.write(srid_of(shape));
  write_polygons(file, format == Format::geojson ? Format::geojson : Format::wkt, shape);
}

/// All of GDAL's files of a target, those that GDAL has made.
void write_ogr(OutputSet& outputs, const Target& target, const std::vector<OgrFile>& files) {
  const std::vector<std::string> endings = ogr_endings(target.format), paths = ogr_paths(target);
  for (std::size_t i = 0; i < endings.size(); ++i) {
    const auto made =
        std::find_if(files.begin(), files.end(), [&](const OgrFile& file) { return file.ending == endings[i]; });
    if (made != files.end()) {
      OutputFile& file = outputs.add(paths[i]);
      file.write(made->bytes);
      file.finish();
    } else if (std::filesystem::exists(paths[i])) {
      // A .prj of other coordinates would speak for these.
      throw Failure(paths[i] + ": found a file that was there before, expected none beside " + target.path);
    }
  }
}

void write_isolated(OutputFile& file, Format format, const Shape& shape) {
  if (format == Format::geojson) return write_isolated_geojson(file, shape);
  if (format == Format::ewkt) file.write(srid_of(shape));
  is_text_geometry(format) ? write_isolated_wkt(file, shape) : write_isolated_csv(file, shape);
}

void write_targets(OutputSet& outputs, const Files& files, const ComplexRun& run, const Shape& shape,
                   const Triangulation& complex) {
  const ProgressLine line("rbpa", run.request.shows_writing, "writing");
  std::optional<Drawing> drawing;
  for (const Target& target : files.targets) {
    stop_if_interrupted();
    if (is_ogr(target.format)) {
      write_ogr(outputs, target, ogr_polygons(target.format, shape));
      continue;
    }
    OutputFile& file = outputs.add(target.path);
    if (is_picture(target.format)) {
      if (!drawing) drawing = drawing_of(run.points, shape.polygons, complex.isolated);
      const Scene scene = place(*drawing, run.request.width);
      target.format == Format::svg ? write_svg(file, scene) : write_png(file, scene);
    } else {
      write_shape(file, target.format, shape);
    }
    file.finish();
  }
  if (!files.isolated) return;
  if (is_ogr(files.isolated->format))
    return write_ogr(outputs, *files.isolated, ogr_isolated(files.isolated->format, shape));
  OutputFile& file = outputs.add(files.isolated->path);
  write_isolated(file, files.isolated->format, shape);
  file.finish();
}

/// GeoJSON in metres looks like any other: said once, whatever else is not.
void caution(const Files& files, const Shape& shape) {
  std::vector<Target> all = files.targets;
  if (files.isolated) all.push_back(*files.isolated);
  const auto first = std::find_if(all.begin(), all.end(), [](const Target& t) { return t.format == Format::geojson; });
  if (first == all.end()) return;
  if (const std::optional<std::string> why = geojson_caution(shape))
    say("rbpa", (first->path == "-" ? "standard output" : first->path) + ": " + *why);
}

/// The complex in arrays, with neighbours, by whichever method. What a method needs is gone before these are made.
Triangulation triangulated(const ComplexRun& run) {
  const ComplexRequest& request = run.request;
  Triangulation arrays;
  if (request.method.makes_mesh()) {
    SolidAlphaComplex complex = build(run.points, run.alpha, request.method, request.options).complex;
    arrays.triangles = triangles(complex);
    arrays.isolated = std::move(complex.isolated);
    arrays.duplicates = std::move(complex.duplicates);
    arrays.distinct = complex.distinct;
  } else {
    arrays = build_arrays(run.points, run.alpha, Complex::solid, false, request.options);
  }
  arrays.neighbors = link_triangles(arrays.triangles, run.points.size(), until_interrupted());
  return arrays;
}

std::vector<Polygon> outlined(const ComplexRun& run, const Triangulation& complex, const PolygonFilter& filter) {
  const ProgressLine line("rbpa", !run.request.options.quiet, "polygons");
  return polygons(run.points, complex, filter, until_interrupted());
}

/// The peaks of runs with millions of points, without these: docs/shape.md.
double bytes_a_point(const ComplexRequest& request) {
  if (request.alpha.rule != AlphaRule::given) return 500;
  return request.method.makes_mesh() ? 280 : 100;
}

std::string made(const std::vector<Polygon>& polygons, const PolygonTotals& totals) {
  char area[32];
  std::snprintf(area, sizeof area, "%.6g", totals.area);
  return counted(polygons.size(), "polygon") + " with " + counted(totals.holes, "hole") + ", area " + area;
}

}  // namespace

void run_shape(const ShapeArguments& arguments) {
  ComplexRequest request = parse_request(arguments);
  request.bytes_a_point = bytes_a_point(request);
  const PolygonFilter filter{.min_hole_area = parse_area("--min-hole-area", arguments.min_hole_area),
                             .min_part_area = parse_area("--min-part-area", arguments.min_part_area)};
  Files files{.targets = parse_shape_targets(arguments.outputs, arguments.output_format,
                                             given({arguments.stats, arguments.isolated}), arguments.points)};
  if (arguments.isolated) files.isolated = parse_isolated(*arguments.isolated);

  ComplexRun run = begin_run(std::move(request));
  require_srid(files, run.crs);
  const Triangulation complex = triangulated(run);
  stop_if_interrupted();
  const std::vector<Polygon> polygons = outlined(run, complex, filter);
  const PolygonTotals totals = total(polygons);
  std::vector<std::optional<std::uint32_t>> polygon_of;
  if (files.have_points())
    polygon_of = polygon_of_points(run.points, complex, complex.duplicates, polygons, filter, until_interrupted());
  const Shape shape{run.points, polygons, polygon_of, run.crs, run.degrees};
  run.stats.build_seconds = run.watch.lap();

  OutputSet outputs;
  write_targets(outputs, files, run, shape, complex);
  run.stats.write_seconds = run.watch.lap();
  if (run.request.stats) {
    run.stats.distinct = complex.distinct;
    run.stats.isolated = complex.isolated.size();
    run.stats.counts = count(complex, Complex::solid);
    run.stats.polygons = polygons.size();
    run.stats.of_polygons = totals;
  }
  end_run(run, outputs);
  caution(files, shape);

  if (polygons.empty())
    say("rbpa",
        "the shape is empty: " + (complex.triangles.empty() ? why_empty(run, complex.distinct)
                                                            : "no part has an area >= " + arguments.min_part_area));
  say_summary(run, complex.duplicates.size(), made(polygons, totals), list_of(files.targets));
}

}  // namespace rbpa::app
