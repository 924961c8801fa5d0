#include <filesystem>
#include <string>
#include <vector>

#include "cli/alpha_report.h"
#include "cli/arguments.h"
#include "cli/radii_run.h"
#include "cli/verbs.h"
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

}  // namespace

void run_report(const ReportArguments& arguments) {
  const std::string& path = arguments.points;
  const Radii request = parse_radii(arguments);
  const RunOptions options = parse_run(arguments.run);
  const PointSource source = parse_source(arguments);
  check_output(arguments.output);
  const std::vector<std::string> outputs = given({arguments.output, arguments.stats});
  require_different(outputs, path, "points");

  RadiiRun run(source, outputs, options, request, true);
  Report report{.source = path == "-" ? run.input() : std::filesystem::path(path).filename().string(),
                .unit = unit_of(run.file),
                .radii = run.radii,
                .recommended = recommended(run.radii)};
  {
    const ProgressLine line = options.line("persistence");
    report.arrays = filtration_arrays(run.delaunay(), run.radii.filtration, until_interrupted());
  }
  run.stats.build_seconds = run.lap();

  {
    const ProgressLine line = run.writing();
    run.add(arguments.output, [&](OutputFile& page) { write_report(page, report); });
  }
  run.stats.write_seconds = run.lap();
  if (arguments.stats) run.add(*arguments.stats, [&](OutputFile& file) { run.write_stats(file); });
  run.publish();
  run.say_empty();
  const std::size_t radii = run.radii.filtration.steps.size();
  run.summarize(counted(run.radii.points, "point") + ", " + std::to_string(radii) +
                (radii == 1 ? " critical radius" : " critical radii") + list_of({arguments.output}));
}

}  // namespace rbpa::app
