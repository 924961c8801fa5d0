// What: computes report() and find_defects() of a soup together.
// Cost: little more than the cost of report() or find_defects() alone.
#pragma once

#include <vector>

#include "meshops/core/api.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"

namespace meshops {

/// Report and defects of a soup.
struct Examination {
  TopologyReport report;
  std::vector<SoupDefect> defects;
};

/// Returns the report and the defects of a soup. Throws what find_defects() throws.
MESHOPS_API Examination examine(const PolygonSoup& soup, const GoOn& go_on = {});

}  // namespace meshops
