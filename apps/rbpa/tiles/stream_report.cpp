#include "tiles/stream_report.h"

#include <string>

#include "io/failure.h"
#include "io/number.h"
#include "rbpa/plane/collinear.h"
#include "shared/arguments.h"
#include "shared/stats.h"

namespace rbpa::app {

void write_stream_stats(OutputFile& file, const StreamRequest& request, const StreamResult& result) {
  const PartialCounts& counts = result.counts;
  Stats stats{.points = counts.points,
              .distinct = counts.points - counts.duplicates,
              .threads = request.threads,
              .alpha = request.alpha,
              .alpha_rule = "given",
              .isolated = counts.isolated};
  stats.counts = ComplexCounts{};
  stats.counts->triangles = counts.triangles;
  stats.counts->points_covered = counts.vertices;
  stats.counts->edges = counts.edges;
  stats.counts->boundary_curves = counts.boundary_curves;
  stats.counts->solid_components = counts.solid_components;
  stats.counts->components = counts.components;
  stats.counts->holes = counts.holes();
  stats.method = "stream";
  if (request.wants_polygons()) {
    stats.polygons = result.polygons;
    stats.of_polygons = {.holes = result.holes, .area = result.area, .perimeter = result.perimeter};
  }
  stats.tiles = result.tiles;
  stats.read_seconds = result.count_seconds + result.cut_seconds;
  stats.count_seconds = result.count_seconds;
  stats.cut_seconds = result.cut_seconds;
  stats.build_seconds = result.compute_seconds;
  stats.write_seconds = result.write_seconds;
  write_stats(file, stats);
}

void say_stream_result(const StreamRequest& request, const StreamResult& result) {
  if (result.caution) say("rbpa", *result.caution);
  const PartialCounts& counts = result.counts;
  if (counts.triangles == 0)
    say("rbpa", "the complex is empty: " + why_no_triangle(counts.points - counts.duplicates, false, request.alpha));
  else if (request.wants_polygons() && result.polygons == 0)
    say("rbpa", "the shape is empty: no part has an area >= " + text_of(request.filter.min_part_area));
  if (request.quiet) return;
  std::string text = text_of_points(counts.points, counts.duplicates) + " in " + counted(result.tiles, "tile") + ", " +
                     counted(counts.triangles, "triangle") + ", " + std::to_string(counts.isolated) + " isolated";
  if (request.wants_polygons())
    text += ", " + text_of_polygons(result.polygons, result.holes) + ", area " + rounded(result.area, 6);
  say("rbpa", text + list_of(request.targets));
}

}  // namespace rbpa::app
