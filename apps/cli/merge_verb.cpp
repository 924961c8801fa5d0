#include <string>
#include <utility>
#include <vector>

#include "cli/run.h"
#include "cli/stats.h"
#include "cli/stream_arguments.h"
#include "cli/stream_report.h"
#include "cli/verbs.h"
#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/progress_line.h"
#include "tasks/merge_task.h"

namespace rbpa::app {
namespace {

StreamRequest parse_request(const MergeArguments& arguments) {
  StreamRequest request{.memory = parse_memory(arguments.memory),
                        .scratch = arguments.scratch,
                        .quiet = arguments.quiet,
                        .shows_progress = !arguments.quiet && !written_to_terminal(arguments.outputs),
                        .stats = arguments.stats};
  if (arguments.scratch && arguments.scratch->empty())
    throw WrongUsage("--scratch: found an empty name, expected a folder");
  if (arguments.outputs.empty() && !arguments.stats)
    throw WrongUsage("found no -o OUT, expected at least one (or --stats)");
  for (const std::string& path : arguments.outputs) {
    if (ending(path) == "partial") continue;
    if (ending(path) == "ply")
      throw WrongUsage(path + ": found a mesh, expected geojson, wkt or npy: rbpa tile writes the mesh of a tile");
    request.targets.push_back(parse_stream_target(path, arguments.output_format));
  }
  const bool any_partial = request.targets.size() < arguments.outputs.size();
  if (any_partial && arguments.outputs.size() > 1)
    throw WrongUsage("-o: found a partial and " + counted(arguments.outputs.size() - 1, "other file") +
                     ", expected one partial, or the files of the whole run");
  return request;
}

void require_different_files(const MergeArguments& arguments, bool is_partial) {
  std::vector<std::string> files = arguments.outputs;
  if (is_partial)
    for (const std::string& path : side_paths(arguments.outputs.front())) files.push_back(path);
  if (arguments.stats) files.push_back(*arguments.stats);
  for (const std::string& path : arguments.partials) require_different(files, path, "a partial");
}

void merge_to_partial(const MergeArguments& arguments, Run& run) {
  PartialFile merged = merge_files(arguments.partials);
  const PartialCounts counts = merged.partial.counts();
  const std::uint64_t tiles = merged.tiles.size(), of = merged.run.tiles;
  Stats stats = stats_of(counts, merged.run.alpha, 1);
  stats.build_seconds = run.lap();
  add_partial(run.files(), arguments.outputs.front(), std::move(merged));
  stats.write_seconds = run.lap();
  if (arguments.stats) run.add(*arguments.stats, [&](OutputFile& file) { write_stats(file, stats); });
  run.publish();
  run.summarize(counted(arguments.partials.size(), "partial") + " of " + std::to_string(tiles) + " of " +
                counted(of, "tile") + ", " + counted(counts.points, "point") + " -> " + arguments.outputs.front());
}

void merge_to_targets(const MergeArguments& arguments, StreamRequest request, Run& run) {
  PartialFile whole = merge_files(arguments.partials);
  const double seconds = run.lap();
  request.alpha = whole.run.alpha;
  const StreamResult result = finish_run(request, std::move(whole), run.files(), [&](const StreamResult& done) {
    StreamResult timed = done;
    timed.compute_seconds = seconds;
    timed.write_seconds = run.lap();
    if (request.stats) run.add(*request.stats, [&](OutputFile& file) { write_stream_stats(file, request, timed); });
  });
  say_stream_result(request, result);
}

}  // namespace

void run_merge(const MergeArguments& arguments) {
  const StreamRequest request = parse_request(arguments);
  const bool is_partial = !arguments.outputs.empty() && request.targets.empty();
  require_different_files(arguments, is_partial);
  const ProgressLine line("rbpa", request.shows_progress, "merging");
  Run run("", arguments.outputs, {.quiet = arguments.quiet});
  is_partial ? merge_to_partial(arguments, run) : merge_to_targets(arguments, request, run);
}

}  // namespace rbpa::app
