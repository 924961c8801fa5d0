// What: closes a surface of points in space by filling every boundary curve, as required for 3D printing and volumes.
// How:  fill_holes() fills all curves. If some curves stay open, removes the triangles around them, and fills the
//       resulting holes. Once no curve is open, removes triangles around points at which the surface touches itself,
//       and fills again. There are at most four rounds in all.
// Law:  the result depends on the points and the triangles only, not on any order. No point is added.
// Cost: up to five times that of fill_holes().
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// The result of close_surface(): a closed surface if every hole is filled. Old triangles are the kept ones, in the
/// given order; `holes` has the outcomes for surface_curves() of the kept triangles, glued by indexable_surface().
struct ClosedSurface : FilledSurface {
  std::vector<bool> kept = {};  ///< for each triangle of the given surface, whether it is kept
  std::size_t given_up = 0;     ///< number of triangles removed; 0 unless the surface is closed
};

/// Fills all boundary curves. Removes triangles only if the removal closes the surface or, if the filled surface is
/// closed anyway, only if it then touches itself at fewer points. Also removes components that thereby become
/// islands(). Removes at most a twentieth of the triangles in all. A round is dropped, and is the last one, if the
/// surface would have more components than the given one. No round begins while a curve of more than 256 edges is open.
/// Requires: `surface` is an indexable_surface() (split_fans.h) of `points`.
/// Throws:   what fill_holes() of curves throws.
RBPA_API ClosedSurface close_surface(std::span<const Point3> points, const Surface& surface,
                                     const SurfaceOptions& options = {});

/// Returns for each point, by index, whether several fans of triangles meet at the point, so that the surface touches
/// itself.
/// Throws: what split_fans() throws; ContractViolation when a corner is not an index of a point.
/// Cost:   that of split_fans().
RBPA_API std::vector<bool> touching_points(std::span<const Point3> points, const Surface& surface,
                                           const GoOn& go_on = {});

}  // namespace rbpa
