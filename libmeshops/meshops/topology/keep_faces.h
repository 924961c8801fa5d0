// What: removes faces from a soup, and all points that no remaining face has.
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
  std::vector<std::uint32_t> point_was;  ///< for each point, its number in the given soup; ascending
  std::vector<std::size_t> face_was;     ///< for each face, its number in the given soup; ascending
};

/// Returns a soup of the faces f for which kept[f] is true, in their old order, and of the corners of these faces.
/// Requires: require_parted() does not throw; `kept` has a value for each face; every corner of a kept face is a point.
/// Throws:   ContractViolation that describes the requirement that is not met; Cancelled.
MESHOPS_API SoupPart keep_faces(const PolygonSoup& soup, const std::vector<bool>& kept, const GoOn& go_on = {});

}  // namespace meshops
