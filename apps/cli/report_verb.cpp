#include "cli/report_verb.h"

#include <filesystem>
#include <limits>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/arguments.h"
#include "cli/build.h"
#include "cli/progress.h"
#include "cli/stats.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/interrupt.h"
#include "io/message.h"
#include "io/output_file.h"
#include "io/same_file.h"
#include "report/write_report.h"

namespace rbpa::app {
namespace {

void check_output(const std::string& output) {
  if (output.empty()) throw WrongUsage("-o: found an empty name, expected a path or -");
  if (output == "-") return;
  const std::string_view found = ending(output);
  if (found != "html" && found != "htm")
    throw WrongUsage(output + ": found the ending " + in_quotes(found) + ", expected html");
}

Report examine(const std::vector<Point>& points, const std::string& path, std::size_t most_components,
               const RunOptions& run) {
  Report report{.source = path == "-" ? "standard input" : std::filesystem::path(path).filename().string(),
                .points = points.size(),
                .most_components = most_components};
  const SolidAlphaComplex delaunay = build(points, std::numeric_limits<double>::infinity(), run);
  {
    const ProgressLine line("rbpa", !run.quiet, "radii of " + counted(delaunay.mesh.n_faces(), "triangle"));
    report.filtration = filtration(delaunay, points, until_interrupted());
  }
  stop_if_interrupted();
  report.least_covering = smallest_covering(report.filtration);
  report.least_connected = smallest_covering(report.filtration, most_components);
  const ProgressLine line("rbpa", !run.quiet, "persistence");
  report.arrays = filtration_arrays(delaunay, points, report.filtration, until_interrupted());
  return report;
}

}  // namespace

void run_report(const ReportArguments& arguments) {
  const std::size_t most_components = parse_components(arguments.components);
  const RunOptions run = parse_run(arguments.run);
  const PointSource source = parse_source(arguments);
  check_output(arguments.output);
  std::vector<std::string> outputs{arguments.output};
  if (arguments.stats) outputs.push_back(*arguments.stats);
  require_different(outputs, arguments.points, "points");
  Stopwatch watch;
  const std::vector<Point> points = read(source, run.quiet).points;
  Stats stats{.read_seconds = watch.lap()};
  const Report report = examine(points, arguments.points, most_components, run);
  stats.build_seconds = watch.lap();

  OutputSet files;
  {
    const ProgressLine line("rbpa", !run.quiet && !written_to_terminal(outputs), "writing");
    OutputFile& page = files.add(arguments.output);
    write_report(page, report);
    page.finish();
  }
  stats.write_seconds = watch.lap();
  if (arguments.stats) {
    stats.points = points.size();
    stats.threads = threads_used(points.size(), run.threads);
    stats.distinct = report.filtration.distinct;
    OutputFile& file = files.add(*arguments.stats);
    write_stats(file, stats);
    file.finish();
  }
  files.publish();
  const std::size_t radii = report.filtration.steps.size();
  if (radii == 0) {
    const char* why = report.filtration.distinct < 3 ? "fewer than three distinct points" : "all points are collinear";
    say("rbpa", std::string("the complex is empty at every alpha: ") + why);
  }
  if (!run.quiet)
    say("rbpa", counted(points.size(), "point") + ", " + std::to_string(radii) +
                    (radii == 1 ? " critical radius" : " critical radii") + " -> " +
                    (arguments.output == "-" ? "standard output" : arguments.output));
}

}  // namespace rbpa::app
