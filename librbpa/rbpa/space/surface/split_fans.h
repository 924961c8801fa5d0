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

/// The triangles of a surface, with a vertex for each fan.
struct SplitFans {
  /// The triangles, and the corners of each triangle, in the order of the surface. Corners are numbers of vertices.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// The input index of each vertex, ascending; vertices of one point are sorted by their first triangles.
  std::vector<std::uint32_t> point;
};

/// Returns the triangles with a vertex for each fan. Triangles at a point share a vertex if glued sides lead from one
/// triangle to the other around the point.
/// Requires: fewer than 2^32 corners; not checked.
/// Throws:   ContractViolation as require_linked() (triangle_arrays.h) throws it for any indices of points; Cancelled.
RBPA_API SplitFans split_fans(const Surface& surface, const GoOn& go_on = {});

/// Returns the surface, glued so that vertex indices determine the gluing: in the split_fans() of the result, every
/// edge between two vertices has one triangle, or two that are neighbors. All members but `neighbors` are as given. If
/// an edge between two vertices has more than two triangles, for example where bodies touch along the edge or on both
/// sides of a sheet, all its sides are unglued, which cuts the fans at its ends. Two open sides that are then between
/// the same two vertices are glued, even if they were open before.
/// Requires: what split_fans() requires.
/// Throws:   what split_fans() throws.
/// Cost:     that of split_fans(), and a sort of the sides.
RBPA_API Surface indexable_surface(const Surface& surface, const GoOn& go_on = {});

}  // namespace rbpa
