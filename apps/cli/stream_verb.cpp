#include "cli/stream_verb.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <thread>

#include "cli/arguments.h"
#include "cli/stats.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/message.h"
#include "io/number.h"
#include "io/output_file.h"
#include "io/progress_line.h"
#include "io/same_file.h"
#include "io/whole_number.h"
#include "stream/budget.h"
#include "stream/run_stream.h"

namespace rbpa::app {
namespace {

namespace fs = std::filesystem;

/// A number of bytes, with K, M, G or T behind it for powers of 1024.
std::uint64_t parse_memory(const std::string& text) {
  constexpr std::string_view units = "KMGT";
  std::string digits = text;
  unsigned shift = 0;
  if (!digits.empty() && units.find(static_cast<char>(std::toupper(digits.back()))) != std::string_view::npos) {
    shift = 10 * static_cast<unsigned>(units.find(static_cast<char>(std::toupper(digits.back()))) + 1);
    digits.pop_back();
  }
  const ParsedNumber number = parse_whole_number(digits);
  const double bytes = std::ldexp(number.value, static_cast<int>(shift));
  if (number.fault != NumberFault::none || !(bytes >= static_cast<double>(least_memory)) || bytes > 0x1p60)
    throw WrongUsage("--memory: found " + in_quotes(text) + ", expected a size from " +
                     std::to_string(least_memory >> 20U) + "M on, such as 500M or 1G");
  return static_cast<std::uint64_t>(bytes);
}

double parse_finite_alpha(const RadiusArguments& arguments) {
  const std::string text = arguments.alpha.value_or("");
  const bool is_word = text.starts_with("auto") || text.starts_with("min") || text.starts_with("plateau");
  const std::string advice = " (rbpa alpha on a sample of the points shows them)";
  if (is_word)
    throw WrongUsage("--alpha: found " + in_quotes(text) +
                     ", expected a radius: to choose one all points have to be in "
                     "memory" +
                     advice);
  const AlphaChoice choice = parse_alpha(arguments);
  if (std::isinf(choice.radius))
    throw WrongUsage(
        "--alpha: found inf, expected a finite radius: a circle without bound may pass through any points, "
        "and no tile would be complete" +
        advice);
  return choice.radius;
}

/// All files of points in a folder, sorted by name.
std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && point_format(input_ending(entry.path().native())))
      found.push_back(entry.path().string());
  if (error) throw Failure(folder + ": cannot read the folder: " + error.message());
  if (found.empty())
    bad_input(folder, "a folder without files of points", "some by their endings: " + std::string(point_formats));
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<PointSource> parse_sources(const StreamArguments& arguments) {
  std::vector<std::string> paths;
  for (const std::string& path : arguments.inputs) {
    std::error_code error;
    if (path == "-") throw WrongUsage("POINTS: found -, standard input, expected files: they are read twice");
    if (!fs::is_directory(path, error)) {
      paths.push_back(path);
      continue;
    }
    const std::vector<std::string> files = files_in(path);
    paths.insert(paths.end(), files.begin(), files.end());
  }
  std::vector<PointSource> sources;
  PointArguments one = arguments;
  for (const std::string& path : paths) {
    one.points = path;
    sources.push_back(parse_source(one));
  }
  return sources;
}

/// What says how files are read, as a text that is the same where it is.
std::string text_of(const PointArguments& arguments) {
  std::string text;
  const auto add = [&](const char* name, const std::optional<std::string>& value) {
    if (value) text += std::string(name) + "=" + *value + " ";
  };
  add("format", arguments.format);
  add("columns", arguments.columns);
  add("foreground", arguments.pixels.foreground);
  add("threshold", arguments.pixels.threshold);
  add("where", arguments.where);
  add("crs", arguments.crs);
  add("layer", arguments.layer);
  if (arguments.skip_invalid) text += "skip-invalid ";
  if (arguments.vertices) text += "vertices ";
  if (arguments.shift_longitude) text += "shift-longitude ";
  return text;
}

std::optional<StreamFormat> stream_format(std::string_view name) {
  if (const auto shape = shape_format(name)) {
    if (*shape == ShapeFormat::geojson) return StreamFormat::geojson;
    if (*shape == ShapeFormat::wkt) return StreamFormat::wkt;
  }
  if (const auto mesh = output_format(name)) {
    if (*mesh == OutputFormat::npy) return StreamFormat::npy;
    if (*mesh == OutputFormat::ply) return StreamFormat::ply;
  }
  return std::nullopt;
}

StreamTarget parse_target(const std::string& path, const std::optional<std::string>& otherwise) {
  if (path.empty()) throw WrongUsage("-o: found an empty name, expected a path or -");
  std::optional<StreamFormat> format = path == "-" ? std::nullopt : stream_format(ending(path));
  if (!format && otherwise) format = stream_format(*otherwise);
  if (!format && otherwise) refuse_name("--output-format", *otherwise, stream_formats);
  if (!format && path == "-") throw WrongUsage("-o -: found no --output-format, expected geojson, wkt or npy");
  if (!format) refuse_ending(path, stream_formats, "--output-format");
  if (*format == StreamFormat::ply) {
    const std::size_t star = path.rfind('*');
    if (star == std::string::npos || path.find('/', star) != std::string::npos)
      throw WrongUsage(
          path + ": found a mesh of all tiles, expected a name with a '*' for the number of the tile: 'tiles/*.ply'");
  }
  return {path, *format};
}

StreamRequest parse_request(const StreamArguments& arguments) {
  const RunOptions run = parse_run(arguments.run);
  StreamRequest request{.alpha = parse_finite_alpha(arguments.radius),
                        .memory = parse_memory(arguments.memory),
                        .scratch = arguments.scratch,
                        .keep_tiles = arguments.keep_tiles,
                        .resume = arguments.resume,
                        .threads = run.threads > 0 ? run.threads : std::max(std::thread::hardware_concurrency(), 1U),
                        .quiet = run.quiet,
                        .shows_progress = !run.quiet && !written_to_terminal(arguments.outputs),
                        .stats = arguments.stats};
  if (arguments.tile_size) request.tile_size = parse_whole("--tile-size", *arguments.tile_size, {.least = 1}, "points");
  if (arguments.scratch && arguments.scratch->empty())
    throw WrongUsage("--scratch: found an empty name, expected a folder");
  for (const auto& [given, option] : {std::pair{arguments.resume, "--resume"}, {arguments.keep_tiles, "--keep-tiles"}})
    if (given && !arguments.scratch)
      throw WrongUsage(std::string(option) + ": found no --scratch, expected the folder where tiles are");
  if (arguments.outputs.empty() && !arguments.stats)
    throw WrongUsage("found no -o OUT, expected at least one (or --stats)");
  for (const std::string& path : arguments.outputs)
    request.targets.push_back(parse_target(path, arguments.output_format));
  request.sources = parse_sources(arguments);
  request.options = text_of(arguments);
  return request;
}

void require_different_files(const StreamRequest& request) {
  std::vector<std::string> files;
  for (const StreamTarget& target : request.targets) files.push_back(target.path);
  if (request.stats) files.push_back(*request.stats);
  for (const PointSource& source : request.sources) require_different(files, source.path, "points");
}

void add_stats(OutputSet& outputs, const StreamRequest& request, const StreamResult& result) {
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
  OutputFile& file = outputs.add(*request.stats);
  write_stats(file, stats);
  file.finish();
}

void say_result(const StreamRequest& request, const StreamResult& result) {
  if (result.caution) say("rbpa", *result.caution);
  const PartialCounts& counts = result.counts;
  if (counts.triangles == 0) {
    const std::uint64_t distinct = counts.points - counts.duplicates;
    say("rbpa",
        "the complex is empty: " + (distinct < 3 ? "fewer than three distinct points (" + std::to_string(distinct) + ")"
                                                 : "no triangle has circumradius <= " +
                                                       std::string(std::string_view(ShortestText(request.alpha)))));
  }
  if (request.quiet) return;
  std::string text = counted(counts.points, "point");
  if (counts.duplicates > 0) text += " (" + counted(counts.duplicates, "duplicate") + ")";
  text += " in " + counted(result.tiles, "tile") + ", " + counted(counts.triangles, "triangle") + ", " +
          std::to_string(counts.isolated) + " isolated";
  if (request.wants_polygons()) {
    char area[32];
    std::snprintf(area, sizeof area, "%.6g", result.area);
    text += ", " + counted(result.polygons, "polygon") + " with " + counted(result.holes, "hole") + ", area " + area;
  }
  say("rbpa", text + list_of(request.targets));
}

}  // namespace

void run_stream(const StreamArguments& arguments) {
  const StreamRequest request = parse_request(arguments);
  require_different_files(request);
  OutputSet outputs;
  const StreamResult result = run_stream(request, outputs, [&](const StreamResult& done) {
    if (request.stats) add_stats(outputs, request, done);
  });
  say_result(request, result);
}

}  // namespace rbpa::app
