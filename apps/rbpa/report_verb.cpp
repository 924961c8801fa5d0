#include <filesystem>
#include <string>
#include <vector>

#include "io/bytes/same_file.h"
#include "io/cloud/units.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/interrupt.h"
#include "plane/radii_run.h"
#include "rbpa/base/pair_choice.h"
#include "rbpa/space/persistence/solid_representatives.h"
#include "report/write_report.h"
#include "report/write_space_report.h"
#include "shared/alpha_report.h"
#include "shared/arguments.h"
#include "shared/verbs.h"
#include "space/space_persistence.h"

namespace rbpa::app {
namespace {

void check_output(const std::string& output) {
  if (output.empty()) bad_usage("-o", "an empty name", "a path or -");
  if (output == "-") return;
  const std::string_view found = ending(output);
  if (found != "html" && found != "htm") bad_usage(output, "the ending " + in_quotes(found), "html");
}

std::string name_of_source(const std::string& input, const std::string& path) {
  return path == "-" ? input : std::filesystem::path(path).filename().string();
}

void run_space_report(const ReportArguments& arguments) {
  constexpr std::size_t shown = 100;  // the most pairs of each dimension with representatives
  const SpacePointSource source = parse_space_points(arguments);
  check_output(arguments.output);
  const std::vector<std::string> outputs = given({arguments.output, arguments.run.stats});
  require_different(outputs, arguments.points, "points");

  SpacePersistence run(source, outputs, arguments);
  std::vector<SolidPair> pairs;
  std::vector<SolidRepresentative> found;
  const std::vector<SolidPlateau> plateaus = run.find_plateaus([&](const GoOn& go_on) {
    pairs = chosen(run.pairs, {.top = shown});
    found = solid_representatives(run.file.points, run.filtration, pairs, go_on);
  });
  {
    const ProgressLine line = run.writing();
    run.add(arguments.output, [&](OutputFile& page) {
      write_space_report(page, {.source = name_of_source(run.input(), arguments.points),
                                .points = run.file.points,
                                .filtration = run.filtration,
                                .cover = run.cover,
                                .least_covering = run.least,
                                .least_connected = run.automatic,
                                .plateau = plateaus.empty() ? std::nullopt : std::optional(plateaus.front().alpha),
                                .pairs = run.pairs,
                                .shown = pairs,
                                .representatives = found});
    });
  }
  run.add_stats([&](OutputFile& file) { run.write_stats(file); });
  run.publish();
  run.summarize(counted(run.file.points.size(), "point") + ", " + counted(run.pairs.size(), "pair") +
                list_of({arguments.output}));
}

}  // namespace

void run_report(const ReportArguments& arguments) {
  if (is_in_space(arguments.dimension)) return run_space_report(arguments);
  const std::string& path = arguments.points;
  const Radii request = parse_radii(arguments);
  const RunOptions options = parse_run(arguments.run);
  const PointSource source = parse_source(arguments);
  check_output(arguments.output);
  const std::vector<std::string> outputs = given({arguments.output, arguments.run.stats});
  require_different(outputs, path, "points");

  RadiiRun run(source, outputs, options, request, true);
  Report report{.source = name_of_source(run.input(), path),
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
  run.add_stats([&](OutputFile& file) { run.write_stats(file); });
  run.publish();
  run.say_empty();
  const std::size_t radii = run.radii.filtration.steps.size();
  run.summarize(counted(run.radii.points, "point") + ", " + std::to_string(radii) +
                (radii == 1 ? " critical radius" : " critical radii") + list_of({arguments.output}));
}

}  // namespace rbpa::app
