// What: the radii that the verbs alpha and report print: critical ones, those that cover, plateaus.
#pragma once

#include "rbpa/delaunay.h"
#include "report/radii.h"

namespace rbpa::app {

/// Fills in what follows from the points, for its share and number of components, with progress lines unless
/// quiet. Throws Cancelled after a signal.
void find_radii(Radii& radii, const Delaunay& delaunay, bool with_plateaus, bool quiet);

}  // namespace rbpa::app
