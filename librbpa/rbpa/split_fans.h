// What: the triangles of a surface with a vertex for each fan of triangles, as a file of an oriented manifold has them.
// Law:  a function of the triangles and how they are glued.
// Cost: linear, and a sort of the fans.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/surface.h"

namespace rbpa {

struct SplitFans {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< in the order of the surface; corners are vertices
  std::vector<std::uint32_t> point;  ///< the input index of each vertex; ascending, of one point by their first corners
};

/// Triangles have a vertex in common at a point if one gets from one to the other around it through sides that are glued.
/// Requires: less than 2^32 corners.
/// Throws:   ContractViolation when a triangle is not a neighbor of its neighbor; Cancelled when `go_on`, which is called every
///           few milliseconds, returns false. Empty: never called.
RBPA_API SplitFans split_fans(const Surface& surface, const std::function<bool()>& go_on = {});

/// The same triangles, glued so that their indices determine how: of split_fans() of the result every pair of vertices is the
/// edge of one triangle, or of two that are neighbors. Where one fan comes twice to an edge, as of bodies that touch along it
/// and of both sides of a sheet, the fan is cut there: each part is closed where its ends meet at both vertices, and
/// otherwise the edge becomes boundary.
/// Requires and throws as split_fans(). Cost: that, and a sort of the sides.
RBPA_API Surface indexable_surface(const Surface& surface, const std::function<bool()>& go_on = {});

}  // namespace rbpa
