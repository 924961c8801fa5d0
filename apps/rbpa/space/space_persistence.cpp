#include "space/space_persistence.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/base/error.h"
#include "rbpa/space/solid/solid_radii.h"
#include "shared/alpha_option.h"
#include "shared/progress.h"
#include "shared/stats.h"
#include "space/solid_request.h"

namespace rbpa::app {

bool is_in_space(const std::string& dimension) {
  if (dimension != "2" && dimension != "3") bad_usage("--dimension", in_quotes(dimension), "2 or 3");
  return dimension == "3";
}

SpacePointSource parse_space_points(const RadiiArguments& arguments) {
  refuse_given({{arguments.components != "1", "--components"},
                {arguments.crs.has_value(), "--crs"},
                {arguments.vertices, "--vertices"},
                {arguments.layer.has_value(), "--layer"},
                {arguments.shift_longitude, "--shift-longitude"},
                {arguments.foreground.has_value(), "--foreground"},
                {arguments.threshold.has_value(), "--threshold"}},
               "applies only to --dimension 2");
  return parse_space_source(arguments);
}

SpacePersistence::SpacePersistence(const SpacePointSource& source, const std::vector<std::string>& outputs,
                                   const RadiiArguments& arguments)
    : Run(source.path, outputs, parse_run(arguments.run)) {
  if (arguments.cover) cover = parse_cover(*arguments.cover);
  file = read_points(source);
  read_seconds_ = lap();
  try {
    TriangleProgress progress(!options().quiet, "tetrahedra", text_of_progress);
    filtration = solid_filtration(file.points, {.threads = options().threads, .progress = progress.watch()});
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what());
  }
  const ProgressLine line = options().line("persistence");
  pairs = solid_persistence(filtration, until_interrupted(), options().threads, [&](const GoOn& go_on) {
    least = min_alpha(filtration.delaunay, filtration.tetrahedron_alpha, cover, go_on);
    automatic = auto_alpha(filtration.delaunay, filtration.tetrahedron_alpha, cover, go_on, 1);
  });
  build_seconds_ = lap();
}

void SpacePersistence::drop_faces() {
  SolidFiltration kept;
  kept.delaunay = std::move(filtration.delaunay);
  kept.tetrahedron_alpha = std::move(filtration.tetrahedron_alpha);
  filtration = std::move(kept);
}

std::vector<SolidPlateau> SpacePersistence::find_plateaus(const std::function<void(const GoOn&)>& beside) {
  const ProgressLine line = options().line("plateaus");
  std::vector<SolidPlateau> plateaus = solid_plateaus(file.points, filtration.delaunay, filtration.tetrahedron_alpha,
                                                      until_interrupted(), options().threads, beside);
  build_seconds_ += lap();
  return plateaus;
}

void SpacePersistence::write_stats(OutputFile& out) {
  app::write_stats(out, {{"points", file.points.size()}, {"distinct", filtration.delaunay.distinct}},
                   options().threads_or_all(), {{"read", read_seconds_}, {"build", build_seconds_}, {"write", lap()}});
}

}  // namespace rbpa::app
