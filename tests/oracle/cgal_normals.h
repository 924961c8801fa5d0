// What: normals by CGAL's fit of a plane to the nearest points, which shares no code with ours.
#pragma once

#include <cstddef>

#include "support/space_sets.h"

namespace rbpa_test {

/// Returns unit normals of either sign, each fitted to a point and its `neighbors` nearest others. Requires: distinct
/// points.
Points3 normals_by_cgal(const Points3& points, std::size_t neighbors);

}  // namespace rbpa_test
