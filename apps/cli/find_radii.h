// What: the radii that the verbs alpha and report tell of: critical ones, those that cover, plateaus.
#pragma once

#include <vector>

#include "cli/alpha_report.h"
#include "rbpa/rbpa.h"

namespace rbpa::app {

/// Fills in what follows from the points, for the report's share and number of components, with progress lines unless
/// quiet. Throws Cancelled after a signal.
void find_radii(AlphaReport& report, const SolidAlphaComplex& delaunay, const std::vector<Point>& points,
                bool with_plateaus, bool quiet);

}  // namespace rbpa::app
