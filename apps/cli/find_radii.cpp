#include "cli/find_radii.h"

#include <optional>

#include "cli/progress.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/covering.h"

namespace rbpa::app {

void find_radii(Radii& radii, const Delaunay& delaunay, bool with_plateaus, bool quiet) {
  radii.points = delaunay.points().size();
  {
    const ProgressLine line("rbpa", !quiet,
                            "radii of " + counted(delaunay.triangulation().triangles.size(), "triangle"));
    radii.filtration = filtration(delaunay, until_interrupted());
  }
  stop_if_interrupted();
  const auto least = [&](std::optional<std::size_t> max_components) {
    return smallest_covering(delaunay, radii.filtration, {radii.cover, max_components}, until_interrupted());
  };
  radii.least_covering = least(std::nullopt);
  radii.least_connected = least(radii.max_components);
  if (!with_plateaus) return;
  const ProgressLine line("rbpa", !quiet, "plateaus");
  radii.plateaus = plateaus(delaunay, radii.filtration, until_interrupted());
}

}  // namespace rbpa::app
