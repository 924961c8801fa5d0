#include "cli/fill_verb.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include "cli/arguments.h"
#include "cli/stats.h"
#include "cli/valid_features.h"
#include "io/bytes/available_memory.h"
#include "io/bytes/number.h"
#include "io/bytes/output_file.h"
#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_triangles.h"
#include "io/polygon/read_polygons.h"
#include "io/progress_line.h"
#include "picture/png.h"
#include "picture/svg.h"
#include "rbpa/base/error.h"
#include "rbpa/fill.h"
#include "triangulation/counts.h"

namespace rbpa::app {
namespace {

double parse_positive(const std::string& option, const std::string& text, const std::string& what) {
  const ParsedNumber number = parse_whole_number(text);
  if (number.fault != NumberFault::none || !(number.value > 0))
    throw WrongUsage(option + ": found " + in_quotes(text) + ", expected " + what + ": a number above 0");
  return number.value;
}

/// What the command line asks for.
struct FillRequest {
  std::string path;
  Format format;
  double size;
  std::optional<std::string> size_at;
  std::optional<double> grade;
  std::vector<Target> targets;
  int width;
};

Format parse_format(const std::string& path, const std::optional<std::string>& format) {
  if (path.empty()) throw WrongUsage("POLYGON: found an empty name, expected a path or -");
  if (format) {
    const std::optional<Format> known = find_format(Use::polygons, *format);
    if (!known) refuse_name("--format", *format, polygon_formats);
    return *known;
  }
  if (path == "-") throw WrongUsage("-: found no --format, expected one of " + std::string(polygon_formats));
  const std::optional<Format> known = find_format(Use::polygons, input_ending(path));
  if (!known) refuse_input(path, polygon_formats, "--format");
  return *known;
}

FillRequest parse(const FillArguments& arguments) {
  FillRequest request{.path = arguments.polygons,
                      .format = parse_format(arguments.polygons, arguments.format),
                      .size = arguments.size == "inf" ? std::numeric_limits<double>::infinity()
                                                      : parse_positive("--size", arguments.size,
                                                                       "inf or a length in units of the polygons"),
                      .size_at = arguments.size_at,
                      .grade = {},
                      .targets = {},
                      .width = parse_width(arguments.width)};
  if (arguments.grade)
    request.grade = parse_positive("--grade", *arguments.grade, "how much sizes grow for each unit of distance");
  if (std::isinf(request.size) && (arguments.grade || arguments.size_at))
    throw WrongUsage("--size inf: found " + std::string(arguments.grade ? "--grade" : "--size-at") +
                     " as well, expected one of them: no point is added");
  request.targets = parse_targets(arguments.outputs, arguments.output_format, given({arguments.stats}),
                                  arguments.polygons, Complex::solid);
  if (request.size_at) {
    if (*request.size_at == "-" && request.path == "-")
      throw WrongUsage("--size-at -: found POLYGON on standard input as well, expected one of them in a file");
    std::vector<std::string> files = given({arguments.stats});
    for (const Target& target : request.targets) files.push_back(target.path);
    require_different(files, *request.size_at, "sizes");
  }
  return request;
}

/// The peak of a run of a million triangles, for each of them: docs/fill.md, section 4.
constexpr double bytes_a_triangle = 320;

/// Throws when so many triangles would take more memory than there is.
void require_memory(const std::string& name, double triangles) {
  const std::optional<double> there = available_memory();
  const double wanted = bytes_a_triangle * triangles;
  if (there && wanted > *there)
    throw BadInput(name + ": found sizes at which about " + short_number(triangles) +
                   " triangles would be made, which take about " + bytes_text(wanted) +
                   " of memory, expected no more than the " + bytes_text(*there) + " there are: larger sizes");
}

/// A line that counts triangles, and hears Ctrl-C.
class FillProgress {
 public:
  explicit FillProgress(bool wanted) : line_("rbpa", wanted, "filling") {}

  /// Before watch() sees the first triangle.
  void expect(double triangles) {
    expected_ = triangles;
    line_.say([triangles](double) { return "about " + short_number(triangles) + " triangles"; });
  }

  std::function<bool(const Progress&)> watch() {
    return [this](const Progress& progress) {
      triangles_ = progress.triangles;
      if (!begun_ && progress.triangles > 0) {
        begun_ = true;
        line_.say([this](double seconds) {
          const auto done = static_cast<double>(triangles_.load());
          const std::string text = short_number(done) + " of about " + short_number(expected_) + " triangles";
          return seconds > 0 ? text + ", " + short_number(done / seconds) + "/s" : text;
        });
      }
      return !interrupted();
    };
  }

 private:
  std::atomic<std::size_t> triangles_ = 0;
  double expected_ = 0;
  bool begun_ = false;
  ProgressLine line_;
};

std::string name_of(const FillRequest& request) { return request.path == "-" ? "standard input" : request.path; }

PolygonFile read(const FillRequest& request, bool quiet) {
  std::optional<ProgressLine> line(std::in_place, "rbpa", !quiet && !read_from_terminal(request.path), "reading");
  PolygonFile file = read_polygons(request.path, request.format);
  line.reset();
  for (const std::string& remark : file.vertices.remarks)
    if (!quiet) say("rbpa", name_of(request) + ": " + remark);
  return file;
}

ValidFeatures check(const FillRequest& request, const PolygonFile& file, const FillArguments& arguments) {
  const std::string name = name_of(request);
  ValidFeatures valid = valid_features(file, name, arguments.skip_invalid);
  const std::vector<std::string>& why = valid.why_left_out;
  if (!why.empty() && !arguments.quiet)
    say("rbpa", name + ": " + counted(why.size(), "feature") + " of " + std::to_string(file.features) +
                    (why.size() == 1 ? " is" : " are") + " left out: " + (why.size() == 1 ? "" : "the first is ") +
                    why.front());
  return valid;
}

Filling make(const FillRequest& request, const PolygonFile& file, const ValidFeatures& valid,
             std::span<const SizeAt> sizes, const FillArguments& arguments) {
  FillProgress progress(!arguments.quiet);
  const std::string name = name_of(request);
  try {
    return fill(file.vertices.points, valid.polygons,
                {.size = request.size,
                 .grade = request.grade,
                 .sizes = sizes,
                 .keep_boundary = arguments.keep_boundary,
                 .groups = valid.groups,
                 .progress = progress.watch(),
                 .estimated = [&](double triangles) {
                   require_memory(name, triangles);
                   progress.expect(triangles);
                 }});
  } catch (const InvalidInput& e) {
    throw BadInput(name + ": " + e.what());
  }
}

/// What each triangle is part of.
TriangleFeatures features_of(const Filling& filling, const ValidFeatures& valid, const PolygonFile& file) {
  TriangleFeatures features;
  for (const std::size_t group : filling.groups) features.of_triangle.push_back(valid.feature[group]);
  for (const NumberProperty& property : file.properties) features.numbers.push_back({property.name, property.values});
  return features;
}

/// What pictures and counts are made of.
Triangulation arrays_of(const Filling& filling) {
  Triangulation arrays{.triangles = filling.triangles,
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

void write_targets(OutputSet& outputs, const FillRequest& request, const Filling& filling, const Triangulation& arrays,
                   const TriangleFeatures& features, bool quiet, const std::vector<std::string>& names) {
  const ProgressLine line("rbpa", !quiet && !written_to_terminal(names), "writing");
  for (const Target& target : request.targets) {
    stop_if_interrupted();
    OutputFile& file = outputs.add(target.path);
    if (target.format == Format::svg || target.format == Format::png) {
      const Drawing drawing = drawing_of(filling.points, arrays, Complex::solid);
      const Scene scene = place(drawing, request.width);
      target.format == Format::svg ? write_svg(file, scene) : write_png(file, scene);
    } else {
      write_triangles(file, target.format, {filling.points, filling.triangles, {}, {}, &features});
    }
    file.finish();
  }
}

}  // namespace

void run_fill(const FillArguments& arguments) {
  const FillRequest request = parse(arguments);
  Stopwatch watch;
  const PolygonFile file = read(request, arguments.quiet);
  std::vector<SizeAt> sizes;
  if (request.size_at) sizes = read_sizes(*request.size_at);
  Stats stats{.points = file.vertices.points.size(), .read_seconds = watch.lap()};
  const ValidFeatures valid = check(request, file, arguments);
  const Filling filling = make(request, file, valid, sizes, arguments);
  const Triangulation arrays = arrays_of(filling);
  stats.build_seconds = watch.lap();

  OutputSet outputs;
  write_targets(outputs, request, filling, arrays, features_of(filling, valid, file), arguments.quiet,
                arguments.outputs);
  stats.write_seconds = watch.lap();
  const PolygonTotals totals = total(filling.polygons);
  if (arguments.stats) {
    stats.distinct = filling.points.size();
    stats.isolated = arrays.isolated.size();
    stats.counts = count(arrays, Complex::solid);
    stats.method = "fill";
    stats.polygons = filling.polygons.size();
    stats.of_polygons = totals;
    stats.fill = FillStats{.on_boundary = filling.boundary_points - file.vertices.points.size(),
                           .inside = filling.points.size() - filling.boundary_points,
                           .retreats = filling.retreats,
                           .features = file.features,
                           .left_out = valid.why_left_out.size()};
    OutputFile& report = outputs.add(*arguments.stats);
    write_stats(report, stats);
    report.finish();
  }
  outputs.publish();

  if (filling.triangles.empty()) say("rbpa", "there is no triangle: there is no polygon");
  if (arguments.quiet) return;
  char area[32];
  std::snprintf(area, sizeof area, "%.6g", totals.area);
  const std::string left_out =
      valid.why_left_out.empty() ? "" : counted(valid.why_left_out.size(), "invalid feature") + " left out, ";
  say("rbpa", counted(filling.polygons.size(), "polygon") + " with " + counted(totals.holes, "hole") + ", " + left_out +
                  "area " + area + ", " + counted(filling.triangles.size(), "triangle") + " on " +
                  counted(filling.points.size(), "point") + list_of(request.targets));
}

}  // namespace rbpa::app
