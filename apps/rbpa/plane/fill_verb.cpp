#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/available_memory.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_triangles.h"
#include "io/number.h"
#include "io/polygon/read_polygons.h"
#include "picture/picture.h"
#include "plane/shape_outputs.h"
#include "plane/triangle_outputs.h"
#include "plane/valid_features.h"
#include "rbpa/base/error.h"
#include "rbpa/fill.h"
#include "rbpa/filling_values.h"
#include "shared/arguments.h"
#include "shared/progress.h"
#include "shared/run.h"
#include "shared/stats.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

struct FillRequest {
  std::string path;
  Format format;
  double size;
  std::optional<std::string> size_at;
  std::optional<double> grade;
  std::vector<Target> targets;
  int width;
};

FillRequest parse(const FillArguments& arguments) {
  FillRequest request{.path = arguments.polygons,
                      .format = parse_format(Use::polygons, arguments.polygons, arguments.format, "POLYGON"),
                      .size = arguments.size == "inf"
                                  ? std::numeric_limits<double>::infinity()
                                  : parse_real("--size", arguments.size, above_0,
                                               "inf or a length in units of the polygons: a number above 0"),
                      .size_at = arguments.size_at,
                      .grade = {},
                      .targets = {},
                      .width = parse_width(arguments.width)};
  if (arguments.grade)
    request.grade = parse_real("--grade", *arguments.grade, above_0,
                               "how much sizes grow for each unit of distance: a number above 0");
  if (std::isinf(request.size) && (arguments.grade || arguments.size_at))
    throw WrongUsage("--size inf adds no point and cannot be combined with " +
                     std::string(arguments.grade ? "--grade" : "--size-at"));
  request.targets = parse_targets(Use::triangles, arguments, arguments.polygons);
  if (request.size_at)
    check_second_input({"--size-at", *request.size_at, "sizes"}, {"POLYGON", request.path}, request.targets, arguments);
  return request;
}

/// Memory that a run needs for each estimated triangle, in bytes, with a margin: a run that makes a million triangles
/// takes 228 bytes for each triangle at its peak (docs/explanation/plane.md, Triangles of a given size).
constexpr double bytes_a_triangle = 320;

/// Throws BadInput that names both amounts if `triangles` triangles need more memory than is available.
void require_memory(const std::string& name, double triangles) {
  const std::optional<double> there = available_memory();
  const double wanted = bytes_a_triangle * triangles;
  if (there && wanted > *there)
    bad_input(name,
              "sizes at which about " + short_number(triangles) + " triangles would be made, which take about " +
                  bytes_text(wanted) + " of memory",
              "larger sizes, as " + bytes_text(*there) + " are available");
}

ValidFeatures check(const Run& run, const PolygonFile& file, bool skip_invalid) {
  ValidFeatures valid = valid_features(file, run.input(), skip_invalid);
  const std::vector<std::string>& why = valid.why_left_out;
  if (!why.empty())
    run.warning(counted(why.size(), "feature") + " of " + std::to_string(file.features) +
                (why.size() == 1 ? " is" : " are") + " left out: " + (why.size() == 1 ? "" : "the first is ") +
                why.front());
  return valid;
}

Filling make(const Run& run, const FillRequest& request, const PolygonFile& file, const ValidFeatures& valid,
             std::span<const SizeAt> sizes, bool keep_boundary) {
  double expected = 0;
  TriangleProgress progress(!run.options().quiet, "filling", [&](const Progress& made, double seconds) {
    const auto done = static_cast<double>(made.triangles);
    const std::string text = short_number(done) + " of about " + short_number(expected) + " triangles";
    return seconds > 0 ? text + ", " + short_number(done / seconds) + "/s" : text;
  });
  try {
    return fill(file.vertices.points, valid.polygons,
                {.size = request.size,
                 .grade = request.grade,
                 .sizes = sizes,
                 .keep_boundary = keep_boundary,
                 .groups = valid.groups,
                 .progress = progress.watch(),
                 .estimated = [&](double triangles) {
                   require_memory(run.input(), triangles);
                   expected = triangles;
                   progress.say("about " + short_number(triangles) + " triangles");
                 }});
  } catch (const InvalidInput& e) {
    throw BadInput(run.input() + ": " + e.what());
  }
}

/// Returns the number of the feature of each triangle, and the numeric properties of all features.
TriangleFeatures features_of(const Filling& filling, const ValidFeatures& valid, const PolygonFile& file) {
  TriangleFeatures features;
  for (const std::size_t group : filling.groups) features.of_triangle.push_back(valid.feature[group]);
  for (const NumberProperty& property : file.properties) features.numbers.push_back({property.name, property.values});
  return features;
}

/// Returns the heights of the points of the filling; empty if the polygons have no heights or no target stores heights.
std::vector<double> heights_of(const Run& run, const FillRequest& request, const PolygonFile& file,
                               const Filling& filling, const ValidFeatures& valid) {
  std::vector<double> z = file.vertices.z;
  if (!any_has_vertices(request.targets)) return {};
  run.complete_heights(z);
  return z.empty() ? z : values_on_filling(filling, z, valid.groups, until_interrupted());
}

/// Returns the filling as an AlphaComplex, which pictures and counts require.
AlphaComplex arrays_of(const Filling& filling) {
  AlphaComplex arrays{.triangles = filling.triangles,
                      .neighbors = filling.neighbors,
                      .boundary = {},
                      .isolated = {},
                      .duplicates = {},
                      .distinct = filling.points.size(),
                      .edges = {},
                      .points = {}};
  std::vector<bool> is_used(filling.points.size(), false);
  for (const Triangle& triangle : filling.triangles)
    for (const std::uint32_t i : triangle) is_used[i] = true;
  for (std::uint32_t i = 0; i < is_used.size(); ++i)
    if (!is_used[i]) arrays.isolated.push_back(i);
  return arrays;
}

}  // namespace

void run_fill(const FillArguments& arguments) {
  const FillRequest request = parse(arguments);
  Run run(request.path, arguments.outputs, parse_run(arguments.run));
  const PolygonFile file = run.read([&] { return read_polygons(request.path, request.format); });
  run.warning(file.vertices.warnings);
  std::vector<SizeAt> sizes;
  if (request.size_at) sizes = read_sizes(*request.size_at);
  Stats stats{.points = file.vertices.points.size(), .read_seconds = run.lap()};
  const ValidFeatures valid = check(run, file, arguments.skip_invalid);
  const Filling filling = make(run, request, file, valid, sizes, arguments.keep_boundary);
  const AlphaComplex arrays = arrays_of(filling);
  stats.build_seconds = run.lap();

  const TriangleFeatures features = features_of(filling, valid, file);
  const std::vector<double> z = heights_of(run, request, file, filling, valid);
  {
    const ProgressLine line = run.writing();
    for (const Target& target : request.targets) {
      if (is_picture(target.format))
        add_picture(run, target, drawing_of(filling.points, arrays, ComplexKind::solid), request.width,
                    file.vertices.crs);
      else
        add_triangles(run, target, {filling.points, filling.triangles, {}, {}, &features, {}, z}, file.vertices);
    }
  }
  stats.write_seconds = run.lap();
  const PolygonTotals totals = total(filling.polygons);
  if (arguments.run.stats) {
    stats.distinct = filling.points.size();
    stats.isolated = arrays.isolated.size();
    stats.counts = count(filling.points, arrays, ComplexKind::solid, until_interrupted());
    stats.count_seconds = run.lap();
    stats.method = "fill";
    stats.polygons = filling.polygons.size();
    stats.of_polygons = totals;
    stats.fill = FillStats{.on_boundary = filling.boundary_points - file.vertices.points.size(),
                           .inside = filling.points.size() - filling.boundary_points,
                           .retreats = filling.retreats,
                           .features = file.features,
                           .left_out = valid.why_left_out.size()};
    run.add_stats([&](OutputFile& report) { write_stats(report, stats); });
  }
  run.publish();
  caution(request.targets, filling.points, file.vertices);

  if (filling.triangles.empty()) say("rbpa", run.input() + ": there is no triangle, as there is no polygon to fill");
  const std::string left_out =
      valid.why_left_out.empty() ? "" : counted(valid.why_left_out.size(), "invalid feature") + " left out, ";
  run.summarize(text_of_polygons(filling.polygons.size(), totals.holes) + ", " + left_out + "area " +
                rounded(totals.area, 6) + ", " + counted(filling.triangles.size(), "triangle") + " on " +
                counted(filling.points.size(), "point") + run.list_of(request.targets));
}

}  // namespace rbpa::app
