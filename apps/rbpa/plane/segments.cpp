#include "plane/segments.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/lowest_values.h"
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

/// Returns the share of the way from a to b that is nearest to `at`; does not overflow.
double share_of_way(const Point& a, const Point& b, const Point& at) {
  const double x = b.x / 2 - a.x / 2, y = b.y / 2 - a.y / 2, size = std::max(std::abs(x), std::abs(y));
  if (size == 0) return 0;
  const double along = (at.x / 2 - a.x / 2) / size * (x / size) + (at.y / 2 - a.y / 2) / size * (y / size);
  return std::clamp(along / (x / size * (x / size) + y / size * (y / size)), 0.0, 1.0);
}

double mixed(double a, double b, double share) { return (1 - share) * a + share * b; }

/// Returns the sides of the convex hull; if there is no triangle, each point as a side of no length.
std::vector<Segment> hull_of(const AlphaComplex& delaunay) {
  std::vector<Segment> hull;
  for (std::size_t t = 0; t < delaunay.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (delaunay.neighbors[t][k] == AlphaComplex::none)
        hull.push_back({delaunay.triangles[t][(k + 1) % 3], delaunay.triangles[t][(k + 2) % 3]});
  for (const std::uint32_t i : delaunay.isolated) hull.push_back({i, i});
  return hull;
}

/// Returns the height at the place of the hull that is nearest to `at`, which is outside of it.
double height_beside(const Point& at, const std::vector<Segment>& hull, const std::vector<Point>& points,
                     const std::vector<double>& z) {
  double least = std::numeric_limits<double>::infinity(), height = 0;
  for (const auto& [a, b] : hull) {
    const double share = share_of_way(points[a], points[b], at);
    const double away = std::hypot(mixed(points[a].x, points[b].x, share) / 4 - at.x / 4,
                                   mixed(points[a].y, points[b].y, share) / 4 - at.y / 4);
    if (away >= least) continue;
    least = away;
    height = mixed(z[a], z[b], share);
  }
  return height;
}

/// Sets the heights of points that have none, from number `first` on, to those of the triangles of the points before;
/// outside of these to the height at the nearest place of their hull.
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
  std::vector<double> z(file.z.begin(), file.z.begin() + static_cast<std::ptrdiff_t>(first));
  take_lowest(delaunay.triangulation().duplicates, z);
  const Locator locator(points, delaunay.triangulation(), {run.threads, until_interrupted()});
  const std::vector<double> heights =
      locator.interpolate(z, 1, places, {.threads = run.threads, .go_on = until_interrupted()});
  const std::vector<Segment> hull = hull_of(delaunay.triangulation());
  for (std::size_t i = 0; i < which.size(); ++i) {
    stop_if_interrupted();
    file.z[which[i]] = std::isnan(heights[i]) ? height_beside(places[i], hull, points, z) : heights[i];
  }
}

/// Returns the mean of the heights of two segments at a place where they were split.
double height_at(const Point& at, const std::array<std::uint32_t, 2>& crossed, const std::vector<Segment>& segments,
                 const PointFile& file) {
  double mean = 0;
  for (const std::uint32_t s : crossed) {
    const auto [a, b] = segments[s];
    mean += mixed(file.z[a], file.z[b], share_of_way(file.points[a], file.points[b], at)) / 2;
  }
  return mean;
}

/// Returns whether a format has lines, and nothing else that would be read as points.
bool holds_lines(Format format) { return has_lines(format) && !is_table(format); }

}  // namespace

std::optional<SegmentSource> parse_segments(const SegmentArguments& arguments, const PointSource& points,
                                            const std::vector<Target>& targets, const OutputArguments& outputs) {
  if (!arguments.segments) return std::nullopt;
  const std::string& path = *arguments.segments;
  SegmentSource source{.lines = {.path = path,
                                 .vertices = true,
                                 .beside_points = true,
                                 .crs = points.crs,
                                 .shift_longitude = points.shift_longitude},
                       .split_crossings = arguments.split_crossings};
  source.lines.format =
      path == "-" ? Format::by_content : target_of("--segments", path, Use::points, holds_lines).format;
  check_second_input({"--segments", path, "the segments"}, {"POINTS", points.path}, targets, outputs);
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
  std::vector<Duplicate> alike = made.duplicates;  // where a vertex is at a point, the height of the point counts
  std::erase_if(alike, [&](const Duplicate& d) { return d.stands_for < before && d.index >= before; });
  run.take_lowest_heights(alike, file.z);
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
