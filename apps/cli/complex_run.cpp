#include "cli/complex_run.h"

#include <limits>
#include <string_view>
#include <utility>

#include "cli/arguments.h"
#include "cli/build.h"
#include "cli/progress.h"
#include "cli/text_of.h"
#include "io/bytes/available_memory.h"
#include "io/failure.h"
#include "rbpa/collinear.h"

namespace rbpa::app {

ComplexRequest parse_request(const ComplexArguments& arguments) {
  const RunOptions options = parse_run(arguments.run);
  return {.source = parse_source(arguments),
          .alpha = parse_alpha(arguments.radius),
          .method = parse_method(arguments.method),
          .options = options,
          .width = parse_width(arguments.width),
          .stats = arguments.stats,
          .shows_writing = !options.quiet && !written_to_terminal(arguments.outputs)};
}

namespace {

/// Says where there is less memory than the run takes, before it is too late to do something else.
void caution_about_memory(const ComplexRequest& request, std::size_t points) {
  const double wanted = request.bytes_a_point * static_cast<double>(points);
  const std::optional<double> there = available_memory();
  if (request.options.quiet || !there || wanted <= *there) return;
  say("rbpa", (request.source.path == "-" ? "standard input" : request.source.path) + ": " + counted(points, "point") +
                  (points == 1 ? " takes about " : " take about ") + bytes_text(wanted) +
                  " of memory here, expected at most the " + bytes_text(*there) +
                  " there are: rbpa stream makes the same with as much as its --memory says");
}

}  // namespace

ComplexRun begin_run(ComplexRequest request) {
  ComplexRun run{.request = std::move(request)};
  const AlphaChoice& choice = run.request.alpha;
  PointFile file = read(run.request.source, run.request.options.quiet);
  run.points = std::move(file.points);
  run.crs = std::move(file.crs);
  run.degrees = file.degrees;
  run.stats.read_seconds = run.watch.lap();
  caution_about_memory(run.request, run.points.size());
  run.stats.alpha = choose_alpha(choice, run.points, run.request.options);
  if (choice.rule != AlphaRule::given) run.stats.choose_seconds = run.watch.lap();
  // Points without such a radius have no triangle at any.
  run.alpha = run.stats.alpha.value_or(std::numeric_limits<double>::infinity());
  return run;
}

void end_run(ComplexRun& run, OutputSet& outputs) {
  if (run.request.stats) {
    run.stats.alpha_rule = name_of(run.request.alpha);
    run.stats.points = run.points.size();
    run.stats.threads = threads_used(run.points.size(), run.request.options.threads);
    run.stats.method = run.request.method.name();
    OutputFile& file = outputs.add(*run.request.stats);
    write_stats(file, run.stats);
    file.finish();
  }
  outputs.publish();
}

std::string why_empty(const ComplexRun& run, std::size_t distinct) {
  if (distinct < 3) return "fewer than three distinct points (" + std::to_string(distinct) + ")";
  if (are_collinear(run.points)) return "all points are collinear";
  return "no triangle has circumradius <= " + text_of(run.alpha);
}

void say_summary(const ComplexRun& run, std::size_t duplicates, const std::string& made, const std::string& targets) {
  if (run.request.options.quiet) return;
  std::string text = counted(run.points.size(), "point");
  if (duplicates > 0) text += " (" + counted(duplicates, "duplicate") + ")";
  say("rbpa", text + ", " + made + said(run.request.alpha, run.stats.alpha) + targets);
}

}  // namespace rbpa::app
