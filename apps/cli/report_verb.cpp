#include "cli/report_verb.h"

#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/alpha_report.h"
#include "cli/arguments.h"
#include "cli/build.h"
#include "cli/find_radii.h"
#include "cli/progress.h"
#include "cli/stats.h"
#include "io/bytes/output_file.h"
#include "io/bytes/same_file.h"
#include "io/cloud/units.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/interrupt.h"
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

/// What is to be said of the points, and what is to be drawn.
Report examine(const std::string& source, const PointFile& file, const Radii& asked, const RunOptions& run) {
  const Delaunay delaunay = build_delaunay(file.points, run);
  Report report{.source = source, .unit = unit_of(file), .radii = asked};
  find_radii(report.radii, delaunay, true, run.quiet);
  report.recommended = recommended(report.radii);
  const ProgressLine line("rbpa", !run.quiet, "persistence");
  report.arrays = filtration_arrays(delaunay, report.radii.filtration, until_interrupted());
  return report;
}

}  // namespace

void run_report(const ReportArguments& arguments) {
  const std::string& path = arguments.points;
  const Radii asked{.max_components = parse_components(arguments.components),
                    .cover = arguments.cover ? parse_cover(*arguments.cover) : 1};
  const RunOptions run = parse_run(arguments.run);
  const PointSource source = parse_source(arguments);
  check_output(arguments.output);
  std::vector<std::string> outputs{arguments.output};
  if (arguments.stats) outputs.push_back(*arguments.stats);
  require_different(outputs, path, "points");
  Stopwatch watch;
  const PointFile file = read(source, run.quiet);
  const std::size_t points = file.points.size();
  Stats stats{.read_seconds = watch.lap()};
  const std::string source_name = path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
  const Report report = examine(source_name, file, asked, run);
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
    stats.points = points;
    stats.threads = threads_used(points, run.threads);
    stats.distinct = report.radii.filtration.distinct;
    OutputFile& numbers = files.add(*arguments.stats);
    write_stats(numbers, stats);
    numbers.finish();
  }
  files.publish();
  const std::size_t radii = report.radii.filtration.steps.size();
  if (radii == 0) {
    const char* why =
        report.radii.filtration.distinct < 3 ? "fewer than three distinct points" : "all points are collinear";
    say("rbpa", std::string("the complex is empty at every alpha: ") + why);
  }
  if (!run.quiet)
    say("rbpa", counted(points, "point") + ", " + std::to_string(radii) +
                    (radii == 1 ? " critical radius" : " critical radii") + " -> " +
                    (arguments.output == "-" ? "standard output" : arguments.output));
}

}  // namespace rbpa::app
