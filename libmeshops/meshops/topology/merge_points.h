// What: a soup some points of which have become one.
// Law:  what is left has no face that is degenerate or repeats another; merging nothing drops nothing else.
// Cost: linear, and a hash of the faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/api.h"
#include "meshops/core/progress.h"
#include "meshops/topology/keep_faces.h"

namespace meshops {

struct MergedPoints : SoupPart {  ///< of the points that became one, point_was has the least
  std::size_t merged = 0;         ///< points that are gone
  std::size_t corners = 0;        ///< that faces named twice in a row, and name once now; of faces that are left
  std::size_t degenerate = 0;     ///< faces that are gone, as fewer than three corners are left, or one is there twice
  std::size_t duplicate = 0;      ///< faces that are gone, as they repeat an earlier one, in either direction
};

/// Points with the same value of `least` become one; points without a face stay.
/// Requires: least[p] is the least of the points that become one with p; every corner is a point.
/// Throws:   ContractViolation that names what is not so, and when there are 2³⁰ corners, points or faces, or more;
///           Cancelled.
MESHOPS_API MergedPoints merge_points(const PolygonSoup& soup, std::span<const std::uint32_t> least,
                                      const GoOn& go_on = {});

}  // namespace meshops
