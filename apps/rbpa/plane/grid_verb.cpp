#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/write_heights.h"
#include "picture/picture.h"
#include "plane/segments.h"
#include "plane/shape_outputs.h"
#include "plane/triangle_outputs.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/collinear.h"
#include "shared/arguments.h"
#include "shared/method.h"
#include "shared/stats.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

constexpr std::string_view every = "every:";

bool is_raster(Format format) { return format == Format::esri_grid || format == Format::npy; }
bool is_of_lines(Format format) { return !is_raster(format); }

struct GridRequest {
  PointSource source;
  AlphaOption alpha;
  std::optional<double> cell = std::nullopt, step = std::nullopt;
  std::optional<PointBox> extent = std::nullopt;
  std::vector<double> levels = {};
  InterpolateOptions how = {};
  int width = 0;
  std::vector<Target> rasters = {}, lines = {};
  std::optional<SegmentSource> segments = std::nullopt;
  RunOptions run = {};
};

GridRequest parse(const GridArguments& arguments) {
  GridRequest request{.source = parse_source(arguments), .alpha = parse_alpha({.alpha = arguments.alpha})};
  request.run = parse_run(arguments.run);
  if (arguments.value == "z")
    request.source.heights = true;
  else
    request.source.keeps = FieldChoice{{{"", arguments.value}}};  // optional: values_of() reports what is missing
  if (arguments.method != "linear" && arguments.method != "natural")
    bad_usage("--method", in_quotes(arguments.method), "linear or natural");
  if (arguments.method == "natural") request.how.method = Interpolation::natural_neighbor;
  request.how.threads = request.run.threads;
  request.how.go_on = until_interrupted();
  if (arguments.cell) request.cell = parse_real("--cell", *arguments.cell, above_0, "a size above 0");
  constexpr double any = std::numeric_limits<double>::max();
  if (arguments.contours && arguments.contours->starts_with(every))
    request.step = parse_real("--contours", arguments.contours->substr(every.size()), above_0, "every:STEP, above 0");
  else if (arguments.contours)
    for (const std::string_view word : split_at_commas(*arguments.contours))
      request.levels.push_back(
          parse_real("--contours", std::string(word), {-any, any}, "heights with commas between them, or every:STEP"));
  std::sort(request.levels.begin(), request.levels.end());
  request.levels.erase(std::unique(request.levels.begin(), request.levels.end()), request.levels.end());
  if (arguments.extent) request.extent = parse_box("--extent", *arguments.extent);
  request.width = parse_width(arguments.width);
  const std::vector<Target> targets = parse_targets(Use::heights, arguments, arguments.points);
  for (const Target& target : targets) (is_raster(target.format) ? request.rasters : request.lines).push_back(target);
  const auto require = [](const std::vector<Target>& files, bool is_given, const std::string& option, auto fits) {
    if (!files.empty() && !is_given) throw WrongUsage(output_name(files[0].path) + " requires " + option);
    if (files.empty() && is_given)
      throw WrongUsage(option + " requires an OUT in one of " + endings(Use::heights, fits));
  };
  require(request.rasters, arguments.cell.has_value(), "--cell", is_raster);
  require(request.lines, arguments.contours.has_value(), "--contours", is_of_lines);
  request.segments = parse_segments(arguments, request.source, targets, arguments);
  if (request.segments)
    refuse_given({{arguments.value != "z", "--value"},
                  {arguments.method == "natural", "--method natural"},
                  {arguments.contours.has_value() && arguments.alpha != "inf", "--contours with --alpha"}},
                 "cannot be combined with --segments");
  if (arguments.extent && !arguments.cell) throw WrongUsage("--extent requires --cell");
  return request;
}

/// Returns the value of each point. Throws BadInput that names the first point without a finite value.
std::vector<double> values_of(const std::string& value, PointFile& file, const std::string& input) {
  std::vector<double> values = std::move(file.z);
  if (value == "z") {
    if (values.empty() && !file.points.empty())
      bad_input(input, "points without z", "heights (--value NAME takes a column)");
  } else {
    PointColumn column = require_column(file.kept, value, "--value", input);
    if (column.is_text || !become_numbers(column)) bad_input(input, "texts in column " + in_quotes(value), "numbers");
    values.clear();
    for (std::size_t i = 0; i < column.size(); ++i) values.push_back(column.value<double>(i));
  }
  const auto bad = std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
  if (bad == values.end()) return values;
  const auto at = static_cast<std::size_t>(bad - values.begin());
  const std::size_t number = file.index.empty() ? at : file.index[at];
  bad_input(input,
            "point " + std::to_string(number) + ", counted from 0, without a finite value of " + in_quotes(value),
            "one for each point (--where leaves points out)");
}

/// Returns a drawing of the lines, which refers to `corners` and `edges`: these receive the points and the sides.
Drawing drawing_of_lines(const Contours& lines, std::vector<Point>& corners, std::vector<Edge>& edges) {
  for (const Contour& line : lines) {
    const auto first = static_cast<std::uint32_t>(corners.size()), n = static_cast<std::uint32_t>(line.points.size());
    corners.insert(corners.end(), line.points.begin(), line.points.end());
    for (std::uint32_t k = 0; k + (line.is_closed ? 0 : 1) < n; ++k) edges.push_back({first + k, first + (k + 1) % n});
  }
  return {corners, {}, {}, {}, edges};
}

/// A run of the verb: the points with their values and triangles.
struct GridRun {
  const GridRequest& request;
  Run& run;
  const PointFile& file;
  const std::vector<double>& values;
  TriangleArrays triangles;  ///< all, with neighbors
  double alpha;
  std::size_t distinct;                 ///< number of distinct points
  std::vector<std::string> empty = {};  ///< what has no content, and why

  /// Writes all rasters at once, block by block, and returns "20 x 30 cells, 550 with a value".
  std::string add_rasters() {
    const auto [left, right] = std::minmax_element(file.points.begin(), file.points.end());
    const auto [low, high] = std::minmax_element(file.points.begin(), file.points.end(),
                                                 [](const Point& a, const Point& b) { return a.y < b.y; });
    const bool any = !file.points.empty();
    Point least = any ? Point{left->x, low->y} : Point{}, greatest = any ? Point{right->x, high->y} : Point{};
    if (const auto& extent = request.extent)
      least = {extent->least[0], extent->least[1]}, greatest = {extent->greatest[0], extent->greatest[1]};
    const Raster raster = raster_around(least, greatest, *request.cell);
    const double lowest = any ? *std::min_element(values.begin(), values.end()) : 0;
    const Locator locator(file.points, triangles, {request.run.threads, until_interrupted()});
    std::vector<OutputFile*> files;
    std::vector<RasterWriter> writers;
    for (const Target& target : request.rasters)
      writers.emplace_back(*files.emplace_back(&run.files().add(target.path)), target.format, raster, lowest);
    std::size_t with_value = 0;
    InterpolateOptions how = request.how;
    how.alpha = alpha;
    const auto take = [&](std::span<const double> cells) {
      with_value +=
          static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [](double v) { return !std::isnan(v); }));
      for (RasterWriter& writer : writers) writer.write(cells);
    };
    interpolate_grid(locator, values, raster, take, how);
    for (OutputFile* written : files) written->finish();
    if (with_value == 0) empty.push_back("no cell has a value: " + why_no_value());
    return std::to_string(raster.columns) + " x " + std::to_string(raster.rows) + " cells, " +
           std::to_string(with_value) + " with a value";
  }

  std::string why_no_value() const {
    if (triangles.triangles.empty())
      return why_no_triangle(distinct, are_collinear(file.points, until_interrupted()), alpha);
    return "the center of no cell is in a triangle" +
           (std::isinf(alpha) ? "" : " of circumradius <= " + text_of(alpha));
  }

  std::string why_no_line(const std::vector<double>& levels) const {
    if (values.empty()) return "there is no point";
    const auto ends = std::minmax_element(values.begin(), values.end());
    const double low = *ends.first, high = *ends.second;
    if (std::none_of(levels.begin(), levels.end(), [&](double h) { return low < h && h <= high; }))
      return "no height of --contours is above the lowest, " + text_of(low) + ", and up to the highest, " +
             text_of(high);
    if (triangles.triangles.empty()) return why_no_value();
    return "no triangle" + (std::isinf(alpha) ? "" : " of circumradius <= " + text_of(alpha)) + " reaches a height";
  }

  /// Writes all files of contour lines, and returns "12 contour lines at 3 heights".
  std::string add_lines() {
    const std::vector<double> levels = request.step ? levels_every(*request.step, values) : request.levels;
    AlphaComplex part;
    if (!std::isinf(alpha))
      part = build(file.points, alpha, {}, ComplexKind::solid, Links::neighbors, request.run).complex;
    const Contours lines = contours(file.points, std::isinf(alpha) ? triangles : part, values, levels,
                                    {request.run.threads, until_interrupted()});
    std::vector<Point> corners;
    std::vector<Edge> edges;
    std::optional<Drawing> drawing;
    for (const Target& target : request.lines) {
      stop_if_interrupted();
      if (is_picture(target.format)) {
        if (!drawing) drawing = drawing_of_lines(lines, corners, edges);
        add_picture(run, target, *drawing, request.width, file.crs);
        continue;
      }
      run.add(target.path, [&](OutputFile& output) { write_contours(output, target.format, lines, levels, file.crs); });
    }
    if (lines.empty()) empty.push_back("there is no contour line: " + why_no_line(levels));
    return counted(lines.size(), "contour line") + " at " + counted(levels.size(), "height");
  }
};

}  // namespace

void run_grid(const GridArguments& arguments) {
  const GridRequest request = parse(arguments);
  Run run(arguments.points, arguments.outputs, request.run);
  Stats stats{.threads = run.options().threads_or_all()};
  PointFile file = run.read_points(request.source);
  std::vector<double> values = values_of(arguments.value, file, run.input());
  stats.read_seconds = run.lap();
  stats.alpha = choose_alpha(request.alpha, file.points, run.options());
  stats.alpha_rule = name_of(request.alpha);
  std::optional<Delaunay> delaunay;
  ConstrainedDelaunay constrained;
  std::string made;
  if (request.segments) {
    file.z = std::move(values);
    constrained = triangulate_with_segments(run, *request.segments, file);
    values = std::move(file.z);
    stats.distinct = file.points.size() - constrained.duplicates.size();
    made = text_of_segments(constrained);
  } else {
    delaunay.emplace(build_delaunay(file.points, run.options()));
    stats.distinct = delaunay->triangulation().distinct;
    run.take_lowest_heights(delaunay->triangulation().duplicates, values);
  }
  stats.points = file.points.size();
  stats.build_seconds = run.lap();
  const double alpha = stats.alpha.value_or(std::numeric_limits<double>::infinity());
  const TriangleArrays triangles = delaunay ? TriangleArrays(delaunay->triangulation()) : TriangleArrays(constrained);
  GridRun made_of{request, run, file, values, triangles, alpha, stats.distinct};
  try {
    const ProgressLine line = run.writing();
    if (!request.rasters.empty()) made += ", " + made_of.add_rasters();
    if (!request.lines.empty()) made += ", " + made_of.add_lines();
  } catch (const InvalidInput& e) {  // a cell or a step too small for the extent of the points
    const std::string what = e.what();
    throw WrongUsage((what.starts_with("step") ? "--contours " + *arguments.contours : "--cell") +
                     what.substr(what.find(':')));
  }
  stats.write_seconds = run.lap();
  run.add_stats([&](OutputFile& output) { write_stats(output, stats); });
  run.publish();
  caution(request.lines, file.points, file);
  for (const std::string& what : made_of.empty) say("rbpa", what);
  for (const Target& target : request.rasters)
    if (request.source.crs && target.format == Format::esri_grid)
      run.summarize(output_name(target.path) + " does not name " + request.source.crs->text() +
                    " (gdal_translate -a_srs " + request.source.crs->text() + " does)");
  run.summarize(text_of_points(stats.points, stats.points - stats.distinct) + made +
                alpha_text(request.alpha, stats.alpha) + run.list_of(arguments.outputs));
}

}  // namespace rbpa::app
