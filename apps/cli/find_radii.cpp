#include "cli/find_radii.h"

#include <optional>

#include "cli/progress.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/filtration/covering.h"

namespace rbpa::app {

void find_radii(AlphaReport& report, const SolidAlphaComplex& delaunay, const std::vector<Point>& points,
                bool with_plateaus, bool quiet) {
  report.points = points.size();
  {
    const ProgressLine line("rbpa", !quiet, "radii of " + counted(delaunay.mesh.n_faces(), "triangle"));
    report.filtration = filtration(delaunay, points, until_interrupted());
  }
  stop_if_interrupted();
  const auto least = [&](std::optional<std::size_t> most_components) {
    return smallest_covering(delaunay, report.filtration, {report.cover, most_components}, until_interrupted());
  };
  report.least_covering = least(std::nullopt);
  report.least_connected = least(report.most_components);
  if (!with_plateaus) return;
  const ProgressLine line("rbpa", !quiet, "plateaus");
  report.plateaus = plateaus(delaunay, points, report.filtration, until_interrupted());
}

}  // namespace rbpa::app
