#include <string>
#include <string_view>
#include <vector>

#include "cli/arguments.h"
#include "cli/run.h"
#include "cli/stream_report.h"
#include "cli/verbs.h"
#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/formats.h"
#include "tasks/partial_file.h"
#include "tasks/tile_task.h"

namespace rbpa::app {
namespace {

void set_target(std::optional<std::string>& target, const std::string& path) {
  if (target)
    throw WrongUsage("-o: found " + in_quotes(*target) + " and " + in_quotes(path) +
                     ", expected one file of each kind");
  target = path;
}

TileRequest parse_request(const TileArguments& arguments) {
  TileRequest request{.tile = arguments.tile};
  request.threads = parse_run(arguments.run).threads_or_all();
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

}  // namespace

void run_tile(const TileArguments& arguments) {
  const TileRequest request = parse_request(arguments);
  require_different_files(arguments, request);
  Run run(arguments.tile, arguments.outputs, {.quiet = arguments.run.quiet});
  const TileDone done = [&] {
    const ProgressLine line = run.options().line("computing", written_to_terminal(arguments.outputs));
    return run_tile(request, run.files());
  }();
  if (arguments.stats) {
    Stats stats = stats_of(done.counts, done.alpha, request.threads);
    stats.read_seconds = done.read_seconds;
    stats.build_seconds = done.compute_seconds;
    stats.write_seconds = run.lap() - done.read_seconds - done.compute_seconds;
    run.add(*arguments.stats, [&](OutputFile& file) { write_stats(file, stats); });
  }
  run.publish();
  run.summarize("tile " + std::to_string(done.number) + ": " + counted(done.counts.points, "point") + " and " +
                std::to_string(done.around) + " around, " + counted(done.counts.triangles, "triangle") +
                list_of(arguments.outputs));
}

}  // namespace rbpa::app
