// What: chooses ball radii for points in space from the gaps between neighbors along the surface.
// Law:  the radii depend on the set of points only, not on its order or on threads; points scaled by a power of two
//       have scaled radii. The radii are a heuristic: experience shows that they are good, no proof does.
//       docs/explanation/surfaces.md, section 4.
// Cost: some microseconds a point, for its nearest neighbors.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// Returns at most four radii, ascending, in units of the points. The last radius spans the gaps between neighbors
/// everywhere, except gaps that may be holes: those much larger than nearly all others, and those beyond the nearest
/// neighbors. A smaller radius is added if a ball of less than half the size spans the gaps around at least one point
/// in twenty; where densities differ much, radii differ by more than a factor of 2. The result is empty for points on a
/// line and for fewer than three distinct points.
/// Requires: finite points, fewer than 2^32 − 1.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API std::vector<double> auto_radii(std::span<const Point3> points, const SurfaceOptions& options = {});

/// Returns the least radius of auto_radii() at which surface() has triangles; nothing if there is none. If `normals` is
/// empty, exposed_triangles() takes the place of surface().
/// Throws: as surface().
RBPA_API std::optional<double> radius_with_triangles(std::span<const Point3> points, std::span<const Point3> normals,
                                                     const SurfaceOptions& options = {});

}  // namespace rbpa
