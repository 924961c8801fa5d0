// What: merges points of a soup, and drops the faces that become degenerate or duplicate.
// Law:  no remaining face is degenerate or repeats another; without merged points, only faces that are degenerate or
//       duplicate already are dropped.
// Cost: near-linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/api.h"
#include "meshops/core/progress.h"
#include "meshops/topology/keep_faces.h"

namespace meshops {

/// Soup with merged points; for these, `point_was` has the lowest index.
struct MergedPoints : SoupPart {
  std::size_t merged = 0;      ///< number of points that were removed
  std::size_t corners = 0;     ///< number of repeated corners that were removed from remaining faces
  std::size_t degenerate = 0;  ///< number of removed faces that had fewer than three corners left, or one point twice
  std::size_t duplicate = 0;   ///< number of removed faces that repeat an earlier one, in either direction
};

/// Merges points with the same value of `least`, and drops corners that then repeat the corner before. Points without a
/// face stay.
/// Requires: `least` has a value for each point: least[p] is the lowest index of the points that are merged with p, p
///           included. Every corner is a point.
/// Throws:   ContractViolation as require_parted(), when a requirement is not met (the message names it), and when 2³⁰
///           corners, points or faces are left, or more; Cancelled.
MESHOPS_API MergedPoints merge_points(const PolygonSoup& soup, std::span<const std::uint32_t> least,
                                      const GoOn& go_on = {});

}  // namespace meshops
