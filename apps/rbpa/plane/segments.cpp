#include "plane/segments.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/locate.h"
#include "shared/method.h"
#include "shared/progress.h"

namespace rbpa::app {
namespace {

/// Returns the sides of the lines of a file whose points follow `before` others. Sides of no length are left out.
std::vector<Segment> sides_of(const PointFile& lines, std::size_t before) {
  std::vector<Segment> sides;
  const auto add = [&](std::size_t a, std::size_t b) {
    if (lines.points[a] != lines.points[b])
      sides.push_back({static_cast<std::uint32_t>(before + a), static_cast<std::uint32_t>(before + b)});
  };
  for (const auto& [begin, end, is_closed] : lines.lines) {
    for (std::size_t i = begin; i + 1 < end; ++i) add(i, i + 1);
    if (is_closed && end > begin + 2) add(end - 1, begin);
  }
  return sides;
}

/// Sets the heights of points that have none, from number `first` on, to those of the triangles of the points before.
void drape(PointFile& file, std::size_t first, const RunOptions& run) {
  std::vector<std::uint32_t> which;
  std::vector<Point> places;
  for (auto i = static_cast<std::uint32_t>(first); i < file.z.size(); ++i) {
    if (std::isfinite(file.z[i])) continue;
    which.push_back(i);
    places.push_back(file.points[i]);
  }
  if (which.empty()) return;
  const std::vector<Point> points(file.points.begin(), file.points.begin() + static_cast<std::ptrdiff_t>(first));
  const Delaunay delaunay = build_delaunay(points, run);
  const Locator locator(points, delaunay.triangulation(), {run.threads, until_interrupted()});
  const std::vector<double> heights = locator.interpolate(std::span(file.z).first(first), 1, places,
                                                          {.threads = run.threads, .go_on = until_interrupted()});
  for (std::size_t i = 0; i < which.size(); ++i) file.z[which[i]] = heights[i];
}

/// Returns the mean of the heights of two segments at a place where they were split.
double height_at(const Point& at, const std::array<std::uint32_t, 2>& crossed, const std::vector<Segment>& segments,
                 const PointFile& file) {
  double sum = 0;
  for (const std::uint32_t s : crossed) {
    const auto [a, b] = segments[s];
    const auto distance = [&](std::uint32_t i) { return std::hypot(file.points[i].x - at.x, file.points[i].y - at.y); };
    const double from_a = distance(a), from_b = distance(b);
    sum += (from_b * file.z[a] + from_a * file.z[b]) / (from_a + from_b);
  }
  return sum / 2;
}

}  // namespace

std::optional<SegmentSource> parse_segments(const SegmentArguments& arguments, const std::string& points,
                                            const std::vector<Target>& targets, const OutputArguments& outputs) {
  if (!arguments.segments) return std::nullopt;
  const std::string& path = *arguments.segments;
  SegmentSource source{.lines = {.path = path, .vertices = true, .beside_points = true},
                       .split_crossings = arguments.split_crossings};
  source.lines.format = parse_format(Use::points, path, std::nullopt, "--segments");
  require_readable(Use::points, source.lines.format, {.vertices = "--segments"});
  if (path == "-" && points == "-")
    bad_usage("--segments -", "POINTS on standard input as well", "one of them as a file");
  std::vector<std::string> files = given({outputs.stats});
  for (const Target& target : targets) files.push_back(target.path);
  require_different(files, path, "segments");
  return source;
}

ConstrainedDelaunay triangulate_with_segments(const Run& run, const SegmentSource& source, PointFile& file) {
  const std::string name = input_name(source.lines.path);
  const std::size_t before = file.points.size();
  const bool has_heights = !file.z.empty();
  PointSource wanted = source.lines;
  wanted.heights = has_heights;
  const PointFile lines = run.read_points(wanted);
  const std::vector<Segment> segments = sides_of(lines, before);
  if (segments.empty()) bad_input(name, "no line", "lines or polygons");
  if (lines.crs && file.crs) require_same_crs(lines.crs, name, file.crs, run.input());
  file.points.insert(file.points.end(), lines.points.begin(), lines.points.end());
  if (has_heights) {
    file.z.insert(file.z.end(), lines.z.begin(), lines.z.end());
    file.z.resize(file.points.size(), std::numeric_limits<double>::quiet_NaN());
    drape(file, before, run.options());
    run.complete_heights(file.z);
  }
  ConstrainedDelaunay made;
  try {
    TriangleProgress progress(!run.options().quiet, "triangulating", progress_text);
    made = constrained_delaunay(
        file.points, segments,
        {.split_crossings = source.split_crossings, .threads = run.options().threads, .progress = progress.watch()});
  } catch (const InvalidInput& e) {
    std::string what = e.what();
    if (const std::size_t at = what.find("split_crossings"); at != std::string::npos)
      what.replace(at, std::string_view("split_crossings").size(), "--split-crossings");
    throw BadInput(name + ": " + what);
  }
  for (std::size_t i = 0; i < made.crossed.size(); ++i) {
    const Point& at = made.points[file.points.size()];
    if (has_heights) file.z.push_back(height_at(at, made.crossed[i], segments, file));
    file.points.push_back(at);
  }
  if (!file.index.empty())
    for (std::size_t i = before; i < file.points.size(); ++i)
      file.index.push_back(static_cast<std::uint32_t>(file.all_points + i - before));
  return made;
}

std::string text_of_segments(const ConstrainedDelaunay& made) {
  const std::string edges = ", " + counted(made.edges.size(), "edge") + " on segments";
  return made.crossed.empty() ? edges : edges + ", " + counted(made.crossed.size(), "crossing") + " split";
}

}  // namespace rbpa::app
