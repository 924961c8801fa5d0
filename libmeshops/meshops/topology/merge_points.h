// What: merges points of a soup, and drops the faces that become degenerate or duplicate.
// Law:  no remaining face is degenerate or repeats another; without merged points, only faces that are degenerate or
//       duplicate already are dropped.
// Cost: linear, plus a hash of the faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/api.h"
#include "meshops/core/progress.h"
#include "meshops/topology/keep_faces.h"

namespace meshops {

struct MergedPoints : SoupPart {  ///< for merged points, point_was has their lowest index
  std::size_t merged = 0;         ///< number of points that were removed
  std::size_t corners = 0;        ///< number of repeated corners that were removed from remaining faces
  std::size_t degenerate = 0;     ///< number of removed faces with fewer than three corners left, or one point twice
  std::size_t duplicate = 0;      ///< number of removed faces that repeat an earlier one, in either direction
};

/// Merges points with the same value of `least`. Points without a face stay.
/// Requires: `least` has a value for each point: least[p] is the lowest index of the points that are merged with p, p
///           included. Every corner is a point.
/// Throws:   ContractViolation as require_parted(), when a requirement is not met, which it names, and when there are
///           2³⁰ corners, points or faces, or more; Cancelled.
MESHOPS_API MergedPoints merge_points(const PolygonSoup& soup, std::span<const std::uint32_t> least,
                                      const GoOn& go_on = {});

}  // namespace meshops
