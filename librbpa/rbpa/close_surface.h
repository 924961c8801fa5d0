// What: a surface of points in space closed: every boundary curve filled, as a printer or a volume wants it.
// How:  fill_holes() on all curves. Where some stay open, the triangles around these are given up, then those around what still
//       stays open, and so on, four times at most, and what is then open is filled; likewise the triangles around points at which
//       parts of the surface touch.
// Law:  a function of the points and the triangles, and of no order. No point is added.
// Cost: up to five times that of fill_holes().
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/fill_holes.h"
#include "rbpa/surface.h"

namespace rbpa {

struct ClosedSurface {
  Surface surface;           ///< without levels; closed where every hole is filled
  std::vector<bool> is_new;  ///< of each triangle; the others are those that are kept, in the order in which they were
  std::vector<bool> kept;    ///< of each triangle of the surface that was given
  std::vector<HoleFill> holes;  ///< of each curve that there was to fill
  std::size_t given_up = 0;     ///< triangles; more than 0 only where the surface is closed
};

/// Triangles are given up only where the surface is closed then, or touches itself in fewer points; at most a twentieth of them;
/// not where the surface would fall into more components, nor around a curve of more than 256 edges. Islands, components of
/// less than a hundredth of the area, that are open after that are left out.
/// Requires: an indexable_surface(). Throws: as fill_holes().
RBPA_API ClosedSurface close_surface(std::span<const Point3> points, const Surface& surface,
                                     const SurfaceOptions& options = {});

/// Of each point, whether several fans of triangles meet there: the surface touches itself. Throws: as split_fans().
RBPA_API std::vector<bool> touching_points(std::span<const Point3> points, const Surface& surface,
                                           const std::function<bool()>& go_on = {});

}  // namespace rbpa
