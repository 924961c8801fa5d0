// What: merges points of a soup, and drops the faces that become degenerate or duplicate.
// Law:  no remaining face is degenerate, or repeats another unless both are a wall that repair() keeps. If no points
//       merge, only faces that were degenerate or duplicate before are dropped.
// Cost: near-linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/api.h"
#include "meshops/core/progress.h"
#include "meshops/topology/keep_faces.h"

namespace meshops {

/// Soup with merged points. `point_was` has the lowest index of the points that were merged into each point.
struct MergedPoints : SoupPart {
  std::size_t merged = 0;      ///< number of points that were removed
  std::size_t corners = 0;     ///< number of repeated corners that were removed from remaining faces
  std::size_t degenerate = 0;  ///< number of removed faces with fewer than three corners left, or with a point twice
  std::size_t duplicate = 0;   ///< number of removed faces that repeat an earlier face, in either direction
};

/// Merges points with the same value of `least`, and drops corners that then equal the corner before. Isolated points
/// stay.
/// Requires: `least` has a value for each point: least[p] is the lowest index of the points that are merged with p,
///           including p. Every corner is a point.
/// Throws:   ContractViolation as require_parted() does, if a requirement is not met (the message describes it), or if
///           2³⁰ or more corners, points or faces are left; Cancelled.
///           corners, points or faces are left, or more; Cancelled.
MESHOPS_API MergedPoints merge_points(const PolygonSoup& soup, std::span<const std::uint32_t> least,
                                      const GoOn& go_on = {});

}  // namespace meshops
