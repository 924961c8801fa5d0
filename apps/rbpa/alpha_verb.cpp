#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "picture/filtration_plot.h"
#include "plane/radii_run.h"
#include "rbpa/plane/persistence.h"
#include "rbpa/plane/representatives.h"
#include "rbpa/plane/triangles_by_level.h"
#include "shared/alpha_report.h"
#include "shared/arguments.h"
#include "shared/representative_files.h"
#include "shared/verbs.h"
#include "space/space_alpha.h"
#include "space/space_persistence.h"

namespace rbpa::app {
namespace {

ComplexKind parse_complex(const AlphaArguments& arguments) {
  if (!arguments.complex) return ComplexKind::solid;
  if (!arguments.persistence && !arguments.representatives)
    throw WrongUsage("--complex requires --persistence or --representatives");
  return parse_is_full(*arguments.complex) ? ComplexKind::full : ComplexKind::solid;
}

/// Returns the plot of the steps of `radii` and of `pairs`, with the radii "min", "auto" and "plateau" marked.
FiltrationPlot marked_plot(const Radii& radii, const std::vector<PersistencePair>& pairs) {
  FiltrationPlot plot = plot_of(radii.filtration.steps, pairs);
  plot.least_covering = radii.least_covering;
  plot.least_connected = radii.least_connected;
  if (!radii.plateaus.empty()) plot.plateau = radii.plateaus.front();
  return plot;
}

std::vector<Representative> find_representatives(RadiiRun& run, ComplexKind kind, const RepresentativeRequest& request,
                                                 unsigned threads) {
  const Filtration& filtration = run.radii.filtration;
  if (!request.levels && !request.leaf_capacity)
    return representatives(run.delaunay(), filtration, kind, request.choice, until_interrupted());
  std::vector<double> levels = request.levels.value_or(std::vector<double>());
  if (request.leaf_capacity)
    for (const ArrayLevel& level : triangles_by_level(run.file.points, std::numeric_limits<double>::infinity(),
                                                      {.leaf_capacity = *request.leaf_capacity,
                                                      .threads = threads,
                                                      .progress = [](const Progress&) { return !interrupted(); }})
                                       .levels)
      levels.push_back(level.alpha);
  return level_representatives(run.delaunay(), filtration, levels, kind, request.choice, until_interrupted());
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
  if (is_in_space(arguments.dimension)) return run_space_alpha(arguments);
  refuse_given({{arguments.radii.has_value(), "--radii"}, {arguments.radius_default.has_value(), "--radius-default"}},
               "applies only to --dimension 3");
  if (arguments.has_groups()) return run_group_alpha(arguments);
  const Radii request = parse_radii(arguments);
  const ComplexKind kind = parse_complex(arguments);
  const RunOptions options = parse_run(arguments.run);
  const PointSource source = parse_source(arguments);
  if (arguments.picture) require_plot(*arguments.picture);
  const std::optional<RepresentativeRequest> request_of_pairs = parse_representatives(arguments, false);
  const std::vector<std::string> outputs =
      given({"-", arguments.picture, arguments.representatives, arguments.run.stats});
  require_different(outputs, arguments.points, "points");

  RadiiRun run(source, outputs, options, request, !arguments.csv || arguments.picture);
  AlphaReport report{.radii = run.radii};
  if (arguments.persistence || arguments.picture) {
    const ProgressLine line = options.line("persistence");
    report.pairs = persistence(run.delaunay(), run.radii.filtration, kind, until_interrupted());
  }
  std::vector<Representative> found;
  if (request_of_pairs) {
    const ProgressLine line = options.line("representatives");
    found = find_representatives(run, kind, *request_of_pairs, options.threads);
  }
  run.stats.build_seconds = run.lap();

  // Open files before anything is printed: a file that cannot be written is then refused first.
  OutputFile* picture = arguments.picture ? &run.files().add(*arguments.picture) : nullptr;
  OutputFile* stats_file = arguments.run.stats ? &run.files().add(*arguments.run.stats) : nullptr;
  {
    const ProgressLine line = run.writing();
    if (picture != nullptr) {
      picture->write(svg_of(marked_plot(run.radii, *report.pairs)));
      picture->finish();
      if (!arguments.persistence) report.pairs.reset();
    }
    if (request_of_pairs)
      run.add(request_of_pairs->target.path, [&](OutputFile& out) {
        write_representatives(out, run.file.points, run.file.crs, run.file.degrees, found, run.file.index);
      });
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
