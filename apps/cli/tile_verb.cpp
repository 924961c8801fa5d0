#include "cli/tile_verb.h"

#include <algorithm>
#include <thread>

#include "cli/stats.h"
#include "io/bytes/output_file.h"
#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/progress_line.h"
#include "tasks/partial_file.h"
#include "tasks/tile_task.h"

namespace rbpa::app {
namespace {

void set_target(std::optional<std::string>& target, const std::string& path) {
  if (target)
    throw WrongUsage("-o: found " + in_quotes(*target) + " and " + in_quotes(path) + ", expected one of a kind");
  target = path;
}

TileRequest parse_request(const TileArguments& arguments) {
  TileRequest request{.tile = arguments.tile};
  const unsigned threads = parse_run(arguments.run).threads;
  request.threads = threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1U);
  if (arguments.outputs.empty() && !arguments.stats)
    throw WrongUsage("found no -o OUT, expected at least one (or --stats)");
  for (const std::string& path : arguments.outputs) {
    const std::string_view kind = ending(path);
    if (kind == "partial")
      set_target(request.partial, path);
    else if (kind == "npy")
      set_target(request.triangles, path);
    else if (kind == "ply")
      set_target(request.mesh, path);
    else
      throw WrongUsage("-o: found " + in_quotes(path) + ", expected a name that ends in .partial, .npy or .ply");
  }
  return request;
}

void require_different_files(const TileArguments& arguments, const TileRequest& request) {
  std::vector<std::string> files = arguments.outputs;
  if (request.partial)
    for (const std::string& path : side_paths(*request.partial)) files.push_back(path);
  if (arguments.stats) files.push_back(*arguments.stats);
  require_different(files, arguments.tile, "the tile");
}

void add_stats(OutputSet& outputs, const TileArguments& arguments, const TileRequest& request, const TileDone& done,
               double write_seconds) {
  Stats stats{.points = done.counts.points,
              .distinct = done.counts.points - done.counts.duplicates,
              .threads = request.threads,
              .alpha = done.alpha,
              .alpha_rule = "given",
              .isolated = done.counts.isolated};
  stats.read_seconds = done.read_seconds;
  stats.build_seconds = done.compute_seconds;
  stats.write_seconds = write_seconds;
  OutputFile& file = outputs.add(*arguments.stats);
  write_stats(file, stats);
  file.finish();
}

}  // namespace

void run_tile(const TileArguments& arguments) {
  const TileRequest request = parse_request(arguments);
  require_different_files(arguments, request);
  OutputSet outputs;
  Stopwatch watch;
  const TileDone done = [&] {
    const ProgressLine line("rbpa", !arguments.run.quiet && !written_to_terminal(arguments.outputs), "computing");
    return run_tile(request, outputs);
  }();
  if (arguments.stats)
    add_stats(outputs, arguments, request, done, watch.lap() - done.read_seconds - done.compute_seconds);
  outputs.publish();
  if (arguments.run.quiet) return;
  std::string text = "tile " + std::to_string(done.number) + ": " + counted(done.counts.points, "point") + " and " +
                     std::to_string(done.around) + " around, " + counted(done.counts.triangles, "triangle");
  const char* before = " -> ";
  for (const std::string& path : arguments.outputs) {
    text += before + path;
    before = ", ";
  }
  say("rbpa", text);
}

}  // namespace rbpa::app
