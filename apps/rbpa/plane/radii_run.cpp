#include "plane/radii_run.h"

#include <optional>

#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/plane/smallest_covering_alpha.h"
#include "rbpa/rbpa.h"
#include "shared/alpha_option.h"
#include "shared/method.h"

namespace rbpa::app {

Radii parse_radii(const RadiiArguments& arguments) {
  return {.max_components = parse_components(arguments.components),
          .cover = arguments.cover ? parse_cover(*arguments.cover) : 1};
}

namespace {

void find_least(const Delaunay& delaunay, Radii& radii) {
  const auto least = [&](std::optional<std::size_t> max_components) {
    return smallest_covering(delaunay, radii.filtration, {radii.cover, max_components}, until_interrupted());
  };
  radii.least_covering = least(std::nullopt);
  radii.least_connected = least(radii.max_components);
}

}  // namespace

void find_radii(const Delaunay& delaunay, Radii& radii, bool with_plateaus) {
  radii.filtration = filtration(delaunay, until_interrupted());
  find_least(delaunay, radii);
  if (with_plateaus) radii.plateaus = plateaus(delaunay, radii.filtration, until_interrupted());
}

std::optional<std::string> why_no_radius(const Filtration& filtration) {
  if (!filtration.steps.empty()) return std::nullopt;
  return filtration.distinct < 3 ? "fewer than three distinct points" : "all points are collinear";
}

RadiiRun::RadiiRun(const PointSource& source, const std::vector<std::string>& outputs, const RunOptions& options,
                   const Radii& request, bool with_plateaus)
    : Run(source.path, outputs, options), file(read_points(source)), radii(request) {
  stats.points = radii.points = file.points.size();
  stats.read_seconds = lap();
  delaunay_.emplace(build_delaunay(file.points, options));
  {
    const ProgressLine line =
        options.line("radii of " + counted(delaunay().triangulation().triangles.size(), "triangle"));
    radii.filtration = filtration(delaunay(), until_interrupted());
  }
  stats.distinct = radii.filtration.distinct;
  stop_if_interrupted();
  find_least(delaunay(), radii);
  if (!with_plateaus) return;
  const ProgressLine line = options.line("plateaus");
  radii.plateaus = plateaus(delaunay(), radii.filtration, until_interrupted());
}

void RadiiRun::write_stats(OutputFile& report) {
  stats.threads = threads_used(file.points.size(), options().threads);
  rbpa::app::write_stats(report, stats);
}

void RadiiRun::say_empty() const {
  if (const std::optional<std::string> why = why_no_radius(radii.filtration))
    say("rbpa", "the complex is empty at every alpha: " + *why);
}

}  // namespace rbpa::app
