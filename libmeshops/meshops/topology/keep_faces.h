// What: removes faces from a soup, and all points without a remaining face.
// Cost: linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops {

/// Part of a given soup.
struct SoupPart {
  PolygonSoup soup;
  std::vector<std::uint32_t> point_was;  ///< for each point: its number in the given soup; ascending
  std::vector<std::size_t> face_was;     ///< for each face: its number in the given soup; ascending
};

/// Returns the faces f with kept[f], in their old order, and the points that are corners of them.
/// Requires: as require_parted(); `kept` has a value for each face; every corner of a kept face is a point.
/// Throws:   ContractViolation that names the requirement that is not met; Cancelled.
MESHOPS_API SoupPart keep_faces(const PolygonSoup& soup, const std::vector<bool>& kept, const GoOn& go_on = {});

}  // namespace meshops
