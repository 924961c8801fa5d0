#include <optional>
#include <string>
#include <vector>

#include "cli/alpha_report.h"
#include "cli/arguments.h"
#include "cli/radii_run.h"
#include "cli/space_alpha.h"
#include "cli/verbs.h"
#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/interrupt.h"
#include "picture/filtration_plot.h"
#include "rbpa/persistence.h"

namespace rbpa::app {
namespace {

ComplexKind parse_complex(const AlphaArguments& arguments) {
  if (!arguments.complex) return ComplexKind::solid;
  if (!arguments.persistence) throw WrongUsage("--complex: found no --persistence, which is what it is about");
  return parse_is_full(*arguments.complex) ? ComplexKind::full : ComplexKind::solid;
}

bool is_in_space(const AlphaArguments& arguments) {
  if (arguments.dimension != "2" && arguments.dimension != "3")
    throw WrongUsage("--dimension: found " + in_quotes(arguments.dimension) + ", expected 2 or 3");
  return arguments.dimension == "3";
}

/// Of the radii and their pairs.
FiltrationPlot plot_of(const Radii& radii, const std::vector<PersistencePair>& pairs) {
  FiltrationPlot plot{radii.filtration.steps, pairs, radii.least_covering, radii.least_connected};
  if (!radii.plateaus.empty()) plot.plateau = radii.plateaus.front();
  return plot;
}

void write(OutputFile& out, const AlphaReport& report, const AlphaArguments& arguments) {
  if (arguments.json)
    write_json(out, report);
  else if (arguments.csv)
    write_csv(out, report);
  else
    out.write(for_people(report));
  out.finish();
}

}  // namespace

void run_alpha(const AlphaArguments& arguments) {
  if (is_in_space(arguments)) return run_space_alpha(arguments);
  if (arguments.ask_for_groups()) return run_group_alpha(arguments);
  const Radii request = parse_radii(arguments);
  const ComplexKind kind = parse_complex(arguments);
  const RunOptions options = parse_run(arguments.run);
  const PointSource source = parse_source(arguments);
  if (arguments.picture && find_format(Use::shape, ending(*arguments.picture)) != Format::svg)
    throw WrongUsage(*arguments.picture + ": found the ending " + in_quotes(ending(*arguments.picture)) +
                     ", expected svg");
  const std::vector<std::string> outputs = given({"-", arguments.picture, arguments.stats});
  require_different(outputs, arguments.points, "points");

  RadiiRun run(source, outputs, options, request, !arguments.csv || arguments.picture);
  AlphaReport report{.radii = run.radii};
  if (arguments.persistence || arguments.picture) {
    const ProgressLine line = options.line("persistence");
    report.pairs = persistence(run.delaunay(), run.radii.filtration, kind, until_interrupted());
  }
  run.stats.build_seconds = run.lap();

  // What cannot be written is found out before anything is said on standard output.
  OutputFile* picture = arguments.picture ? &run.files().add(*arguments.picture) : nullptr;
  OutputFile* stats_file = arguments.stats ? &run.files().add(*arguments.stats) : nullptr;
  {
    const ProgressLine line = run.writing();
    if (picture != nullptr) {
      picture->write(svg_of(plot_of(run.radii, *report.pairs)));
      picture->finish();
      if (!arguments.persistence) report.pairs.reset();
    }
    write(run.files().add("-"), report, arguments);
    run.stats.write_seconds = run.lap();
    if (stats_file != nullptr) {
      run.write_stats(*stats_file);
      stats_file->finish();
    }
    run.publish();
  }
  run.say_empty();
}

}  // namespace rbpa::app
