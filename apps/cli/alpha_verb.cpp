#include "cli/alpha_verb.h"

#include <cstddef>
#include <limits>
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
#include "io/failure.h"
#include "io/formats.h"
#include "io/interrupt.h"
#include "picture/filtration_plot.h"
#include "rbpa/filtration.h"
#include "rbpa/persistence.h"
#include "rbpa/plateaus.h"

namespace rbpa::app {
namespace {

ComplexKind parse_complex(const AlphaArguments& arguments) {
  if (!arguments.complex) return ComplexKind::solid;
  if (!arguments.persistence) throw WrongUsage("--complex: found no --persistence, which is what it is about");
  return parse_is_full(*arguments.complex) ? ComplexKind::full : ComplexKind::solid;
}

/// What the report is to be about.
struct AlphaRequest {
  std::size_t max_components;
  double cover;
  bool with_plateaus, with_pairs;
  ComplexKind kind;  ///< whose pairs
};

AlphaReport examine(const std::vector<Point>& points, const AlphaRequest& request, const RunOptions& run) {
  const Delaunay delaunay = build_delaunay(points, run);
  AlphaReport report{.radii = {.max_components = request.max_components, .cover = request.cover}};
  find_radii(report.radii, delaunay, request.with_plateaus, run.quiet);
  if (request.with_pairs) {
    const ProgressLine line("rbpa", !run.quiet, "persistence");
    report.pairs = persistence(delaunay, report.radii.filtration, request.kind, until_interrupted());
  }
  return report;
}

FiltrationPlot plot_of(const AlphaReport& report) {
  FiltrationPlot plot{report.radii.filtration.steps, *report.pairs, report.radii.least_covering,
                      report.radii.least_connected};
  if (!report.radii.plateaus.empty()) plot.plateau = report.radii.plateaus.front();
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
  const AlphaRequest request{.max_components = parse_components(arguments.components),
                             .cover = arguments.cover ? parse_cover(*arguments.cover) : 1,
                             .with_plateaus = !arguments.csv || arguments.picture,
                             .with_pairs = arguments.persistence || arguments.picture,
                             .kind = parse_complex(arguments)};
  const RunOptions run = parse_run(arguments.run);
  const PointSource source = parse_source(arguments);
  if (arguments.picture && find_format(Use::shape, ending(*arguments.picture)) != Format::svg)
    throw WrongUsage(*arguments.picture + ": found the ending " + in_quotes(ending(*arguments.picture)) +
                     ", expected svg");
  std::vector<std::string> outputs{"-"};
  if (arguments.picture) outputs.push_back(*arguments.picture);
  if (arguments.stats) outputs.push_back(*arguments.stats);
  require_different(outputs, arguments.points, "points");
  Stopwatch watch;
  const std::vector<Point> points = read(source, run.quiet).points;
  Stats stats{.read_seconds = watch.lap()};
  AlphaReport report = examine(points, request, run);
  stats.build_seconds = watch.lap();

  // What cannot be written is found out before anything is said on standard output.
  OutputSet files;
  OutputFile* picture = arguments.picture ? &files.add(*arguments.picture) : nullptr;
  OutputFile* stats_file = arguments.stats ? &files.add(*arguments.stats) : nullptr;
  std::optional<ProgressLine> line(std::in_place, "rbpa", !run.quiet && !written_to_terminal(outputs), "writing");
  if (picture) {
    picture->write(svg_of(plot_of(report)));
    picture->finish();
    if (!arguments.persistence) report.pairs.reset();
  }
  write(files.add("-"), report, arguments);
  stats.write_seconds = watch.lap();
  if (stats_file) {
    stats.points = points.size();
    stats.threads = threads_used(points.size(), run.threads);
    stats.distinct = report.radii.filtration.distinct;
    write_stats(*stats_file, stats);
    stats_file->finish();
  }
  files.publish();
  line.reset();
  if (report.radii.filtration.steps.empty()) {
    const char* why =
        report.radii.filtration.distinct < 3 ? "fewer than three distinct points" : "all points are collinear";
    say("rbpa", std::string("the complex is empty at every alpha: ") + why);
  }
}

}  // namespace rbpa::app
