// What: gives each fan of triangles of a surface a vertex of its own, as files of oriented manifolds require.
// Law:  a function of the triangles and their gluing.
// Cost: linear, and a sort of the fans.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

struct SplitFans {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< in the order of the surface; corners are vertices
  /// The input index of each vertex, ascending; vertices of one point are sorted by their first corners.
  std::vector<std::uint32_t> point;
};

/// Returns the triangles with a vertex for each fan: triangles at a point share a vertex if glued sides lead from one
/// to the other around the point.
/// Requires: fewer than 2^32 corners.
/// Throws:   ContractViolation when a triangle is not a neighbor of its neighbor; Cancelled.
RBPA_API SplitFans split_fans(const Surface& surface, const GoOn& go_on = {});

/// Returns the triangles of a surface, glued so that vertex indices determine the gluing: in split_fans() of the
/// result, every pair of vertices is an edge of one triangle, or of two that are neighbors. A fan that contains an edge
/// twice, for example where bodies touch along the edge or on both sides of a sheet, is cut there. A part is closed if
/// its two ends meet at both vertices; otherwise the edge becomes boundary.
/// Requires: as split_fans().
/// Throws:   as split_fans().
/// Cost:     that of split_fans(), and a sort of the sides.
RBPA_API Surface indexable_surface(const Surface& surface, const GoOn& go_on = {});

}  // namespace rbpa
