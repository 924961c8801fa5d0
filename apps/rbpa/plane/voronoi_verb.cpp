#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/cloud/units.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/ogr.h"
#include "io/polygon/read_polygons.h"
#include "io/polygon/write_shapes.h"
#include "plane/shape_outputs.h"
#include "rbpa/base/error.h"
#include "rbpa/fill/voronoi_cells.h"
#include "rbpa/plane/outline_polygons.h"
#include "shared/alpha_option.h"
#include "shared/arguments.h"
#include "shared/method.h"
#include "shared/stats.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

struct VoronoiRequest {
  PointSource source;
  std::string clip;                             ///< box, hull, shape, or the path of a file
  std::optional<Format> format = std::nullopt;  ///< of the file
  AlphaOption alpha = {};                       ///< of the shape
  int width = 0;
  std::vector<Target> targets = {};
  RunOptions run = {};
};

constexpr auto holds_fields = [](Format format) {
  return format == Format::geojson || format == Format::csv || is_ogr(format);
};

VoronoiRequest parse(const VoronoiArguments& arguments) {
  VoronoiRequest request{.source = parse_source(arguments), .clip = arguments.clip};
  request.run = parse_run(arguments.run);
  if (arguments.alpha && arguments.clip != "shape") throw WrongUsage("--alpha requires --clip shape");
  request.alpha = parse_alpha({.alpha = arguments.alpha.value_or("plateau")});
  request.width = parse_width(arguments.width);
  request.targets = parse_targets(Use::shape, arguments, arguments.points);
  request.source.keeps = parse_fields_of(arguments.fields, any_of(request.targets, holds_fields),
                                         "an OUT in one of " + endings(Use::shape, holds_fields));
  if (request.clip == "box" || request.clip == "hull" || request.clip == "shape") return request;
  if (request.clip != "-" && request.clip.find('.') == std::string::npos)
    bad_usage("--clip", in_quotes(request.clip), "box, hull, shape, or a file of polygons such as clip.geojson");
  request.format = request.clip == "-" ? Format::by_content : target_of("--clip", request.clip, Use::polygons).format;
  check_second_input({"--clip", request.clip, "the boundary"}, {"POINTS", arguments.points}, request.targets,
                     arguments);
  return request;
}

/// The boundary of the cells.
struct Boundary {
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

/// Returns the boundary, and sets alpha of stats if the boundary is a shape.
Boundary boundary_of(const VoronoiRequest& request, const Run& run, const PointFile& file, const Delaunay& delaunay,
                     Stats& stats) {
  if (request.format) {
    PolygonFile read = run.read([&] { return read_polygons(request.clip, *request.format); });
    if (request.source.shift_longitude) shift_longitude(read.vertices.points, input_name(request.clip));
    if (read.vertices.crs && file.crs && !request.source.crs)
      require_same_crs(read.vertices.crs, input_name(request.clip), file.crs, run.input());
    return {std::move(read.vertices.points), std::move(read.polygons)};
  }
  if (file.points.empty()) return {};
  if (request.clip == "hull") return {file.points, outline_polygons(file.points, delaunay.triangulation())};
  if (request.clip == "box") {
    const auto box = box_around(file.points);
    return {{box.begin(), box.end()}, {{.shell = {{0, 1, 2, 3}}}}};
  }
  stats.alpha = choose_alpha(request.alpha, file.points, run.options());
  stats.alpha_rule = name_of(request.alpha);
  const double alpha = stats.alpha.value_or(std::numeric_limits<double>::infinity());
  const AlphaComplex complex =
      build(file.points, alpha, {}, ComplexKind::solid, Links::neighbors, run.options()).complex;
  return {file.points, outline_polygons(file.points, complex)};
}

/// Returns for each point the first polygon of its cell; that of an equal point before it, if there is one.
std::vector<std::optional<std::uint32_t>> polygon_of_points(const VoronoiCells& cells, const AlphaComplex& delaunay,
                                                            std::size_t points) {
  std::vector<std::optional<std::uint32_t>> polygon_of(points);
  for (auto i = static_cast<std::uint32_t>(cells.of.size()); i-- > 0;) polygon_of[cells.of[i]] = i;
  for (const Duplicate& duplicate : delaunay.duplicates) polygon_of[duplicate.index] = polygon_of[duplicate.stands_for];
  return polygon_of;
}

std::size_t number_of_cells(const VoronoiCells& cells) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.of.size(); ++i) count += i == 0 || cells.of[i] != cells.of[i - 1] ? 1U : 0U;
  return count;
}

}  // namespace

void run_voronoi(const VoronoiArguments& arguments) {
  const VoronoiRequest request = parse(arguments);
  Run run(arguments.points, arguments.outputs, request.run);
  Stats stats{.threads = run.options().threads_or_all()};
  const PointFile file = run.read_points(request.source);
  require_srid(request.targets, file.crs);
  stats.points = file.points.size();
  stats.read_seconds = run.lap();
  const Delaunay delaunay = build_delaunay(file.points, run.options());
  stats.distinct = delaunay.triangulation().distinct;
  VoronoiCells cells;
  {
    const Boundary boundary = boundary_of(request, run, file, delaunay, stats);
    const ProgressLine line = run.options().line("cells");
    try {
      cells = voronoi_cells(delaunay, boundary.points, boundary.polygons, until_interrupted());
    } catch (const InvalidInput& e) {
      throw BadInput(input_name(request.clip) + ": " + e.what());
    }
  }
  stats.build_seconds = run.lap();
  const std::vector<std::optional<std::uint32_t>> polygon_of =
      polygon_of_points(cells, delaunay.triangulation(), file.points.size());
  std::vector<std::uint32_t> isolated;
  for (std::uint32_t i = 0; i < polygon_of.size(); ++i)
    if (!polygon_of[i]) isolated.push_back(i);
  PointColumn index{.name = "point", .type = Scalar::uint32};
  for (const std::uint32_t of : cells.of) index.append(file.index.empty() ? of : file.index[of]);
  std::vector<Attribute> attributes =
      attributes_of(file.kept, {"number", "area", "perimeter", "holes", "points", "point"});
  for (Attribute& attribute : attributes) attribute.rows = cells.of;
  attributes.insert(attributes.begin(), {"point", view_of(index), {}});
  const std::vector<Point> points = with_corners(file.points, cells.points, cells.polygons);
  const Shape shape{points,     cells.polygons, polygon_of, file.crs, file.degrees,
                    file.index, file.kept,      attributes, true};
  {
    const ProgressLine line = run.writing();
    add_shapes(run, request.targets, shape, isolated, request.width);
  }
  stats.write_seconds = run.lap();
  const PolygonTotals totals = total(cells.polygons);
  if (arguments.run.stats) {
    stats.polygons = cells.polygons.size();
    stats.of_polygons = {totals.holes, totals.area, totals.perimeter};
    run.add_stats([&](OutputFile& output) { write_stats(output, stats); });
  }
  run.publish();
  caution(request.targets, shape);
  const std::size_t changed = cells.merged + cells.inserted;
  if (cells.polygons.empty() && stats.points > 0) say("rbpa", "there is no cell: the boundary has no area");
  run.summarize(text_of_points(stats.points, stats.points - stats.distinct) + ", " +
                counted(number_of_cells(cells), "cell") + " of " + counted(cells.polygons.size(), "polygon") +
                ", area " + rounded(totals.area, 6) +
                (changed == 0 ? "" : ", " + counted(changed, "corner") + " moved by rounding") +
                (request.clip == "shape" ? alpha_text(request.alpha, stats.alpha) : "") + run.list_of(request.targets));
}

}  // namespace rbpa::app
