#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/number.h"
#include "io/progress_line.h"
#include "rbpa/plane/collinear.h"
#include "shared/arguments.h"
#include "shared/run.h"
#include "shared/stats.h"
#include "shared/verbs.h"
#include "stream/run_stream.h"
#include "tiles/stream_arguments.h"
#include "tiles/stream_groups.h"

namespace rbpa::app {
namespace {

namespace fs = std::filesystem;

double parse_finite_alpha(const RadiusArguments& arguments) {
  const std::string advice = " (rbpa alpha on a sample of the points shows which radius to choose)";
  const AlphaOption option = parse_alpha(arguments);
  if (option.rule != AlphaRule::given)
    bad_usage("--alpha", in_quotes(*arguments.alpha), "a radius: choosing one needs all points in memory" + advice);
  if (std::isinf(option.radius))
    bad_usage("--alpha", "inf", "a finite radius: with inf a triangle may depend on the points of all tiles" + advice);
  return option.radius;
}

std::vector<PointSource> parse_sources(const StreamArguments& arguments) {
  std::vector<std::string> paths;
  for (const std::string& path : arguments.inputs) {
    std::error_code error;
    if (path == "-") bad_usage("POINTS", "-, standard input", "files, as they are read twice");
    if (!fs::is_directory(path, error)) {
      paths.push_back(path);
      continue;
    }
    const std::vector<std::string> files = files_in(path, arguments, arguments.run.quiet);
    paths.insert(paths.end(), files.begin(), files.end());
  }
  std::vector<PointSource> sources;
  PointArguments one = arguments;
  for (const std::string& path : paths) {
    one.points = path;
    sources.push_back(parse_source(one, {.keys = arguments.group_by}));
  }
  return sources;
}

/// Returns the options about reading files as text, so that the options of two runs can be compared.
std::string reading_options(const PointArguments& arguments) {
  std::string text;
  const auto append = [&](const std::string& words) { text += (text.empty() ? "" : " ") + words; };
  const auto add = [&](const std::string& name, const std::optional<std::string>& value) {
    if (value) append(name + " " + *value);
  };
  add("--format", arguments.format);
  add("--columns", arguments.columns);
  add("--bounds", arguments.bounds);
  add("--foreground", arguments.foreground);
  add("--threshold", arguments.threshold);
  add("--where", arguments.where);
  add("--crs", arguments.crs);
  add("--layer", arguments.layer);
  if (arguments.skip_invalid) append("--skip-invalid");
  if (arguments.vertices) append("--vertices");
  if (arguments.shift_longitude) append("--shift-longitude");
  return text;
}

/// The least --tile-size: handling files would take nearly all the time with fewer points in a tile.
constexpr std::size_t least_tile = 16;

StreamRequest parse_request(const StreamArguments& arguments) {
  const RunOptions run = parse_run(arguments.run);
  StreamRequest request{.alpha = parse_finite_alpha(arguments.radius),
                        .filter = parse_areas(arguments),
                        .memory = parse_memory(arguments.memory),
                        .scratch = arguments.scratch,
                        .keep_tiles = arguments.keep_tiles,
                        .resume = arguments.resume,
                        .threads = run.threads_or_all(),
                        .quiet = run.quiet,
                        .shows_progress = !run.quiet && !written_to_terminal(arguments.outputs),
                        .stats = arguments.run.stats};
  refuse_given({{arguments.resolution.has_value(), "--resolution"}},
               "cannot be combined with rbpa stream, whose memory would grow with the number of cells");
  if (arguments.tile_size)
    request.tile_size = parse_whole("--tile-size", *arguments.tile_size, {.least = least_tile}, "points");
  if (arguments.scratch && arguments.scratch->empty()) bad_usage("--scratch", "an empty name", "a folder");
  if (!request.scratch)
    refuse_given({{arguments.resume, "--resume"}, {arguments.keep_tiles, "--keep-tiles"}},
                 "requires --scratch, the folder with the tiles");
  if (arguments.outputs.empty() && !arguments.run.stats) bad_usage("-o", "no OUT", "at least one (or --stats FILE)");
  for (const std::string& path : arguments.outputs)
    request.targets.push_back(parse_stream_target(path, arguments.output_format));
  if (!request.wants_polygons() && !arguments.group_by)
    refuse_given(
        {{request.filter.min_hole_area > 0, "--min-hole-area"}, {request.filter.min_part_area > 0, "--min-part-area"}},
        "requires polygons: -o FILE.geojson or FILE.wkt");
  if (arguments.group_by) {
    refuse_given({{request.keep_tiles, "--keep-tiles"}}, "cannot be combined with --group-by");
    for (const StreamTarget& target : request.targets)
      if (target.format != StreamFormat::geojson)
        bad_usage("--group-by", output_name(target.path) + ", whose format has no groups here", "geojson");
  }
  request.sources = parse_sources(arguments);
  for (PointSource& source : request.sources) source.threads = run.threads;
  request.options = reading_options(arguments);
  return request;
}

void require_different_files(const StreamRequest& request) {
  std::vector<std::string> files;
  for (const StreamTarget& target : request.targets) files.push_back(target.path);
  if (request.stats) files.push_back(*request.stats);
  for (const PointSource& source : request.sources) require_different(files, source.path, "points");
}

/// Writes the report of --stats.
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

/// Prints warnings about the result, and, unless quiet, the summary.
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

}  // namespace

void run_stream(const StreamArguments& arguments) {
  const StreamRequest request = parse_request(arguments);
  require_different_files(request);
  Run run("", arguments.outputs, {.quiet = request.quiet});
  if (arguments.group_by) return run_stream_groups(request, run);
  const StreamResult result = run_stream(request, run.files(), [&](const StreamResult& done) {
    if (request.stats) run.add(*request.stats, [&](OutputFile& file) { write_stream_stats(file, request, done); });
  });
  say_stream_result(request, result);
}

}  // namespace rbpa::app
