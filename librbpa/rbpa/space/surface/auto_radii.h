// What: chooses ball radii for points in space from the gaps between neighbors along the surface.
// Law:  the radii depend on the set of points only, not on its order or on threads; multiplying all points by a power
//       of two multiplies the radii. The radii are a heuristic: good by experience, without a proof.
//       docs/explanation/surfaces.md, sections 4 and 20.
// Cost: n log n; some microseconds for each point, to find its nearest neighbors.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// Returns at most four radii, ascending, in units of the points. A ball of the last radius spans the gaps between
/// neighbors everywhere, except gaps that may be holes: gaps much larger than nearly all others, and gaps that reach
/// beyond the 32 nearest neighbors. Gaps at outliers, and at points whose neighbors lie in no plane, do not count if at
/// most three points in ten are of these kinds. A smaller radius is added if a ball of less than half the size spans
/// the gaps around more than one point in twenty; where densities differ much, consecutive radii differ by a larger
/// factor than 2. If no point has a gap, as in tiny sets, the only radius is 1.25 times the median of the circumradii
/// of points with their two nearest neighbors. If each point is on a line with its nearest neighbors, as on lines of
/// points that are far apart, the only radius is half the diagonal of the box of the points. The result is empty for
/// fewer than three distinct points, and for points on one line. Distances below 1e-160 of the greatest coordinate
/// count as 0. A radius that is 0 or infinite in double is left out.
/// Requires: finite points, fewer than 2^32 − 1.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API std::vector<double> auto_radii(std::span<const Point3> points, const SurfaceOptions& options = {});

/// Returns the least radius of auto_radii() at which surface() has triangles; nothing if there is none. If `normals` is
/// empty, exposed_triangles() is computed in place of surface().
/// Requires: what surface() requires of points and normals; with empty `normals`, what auto_radii() requires.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
/// Cost:     that of auto_radii(), and of one surface for each radius that is tried.
RBPA_API std::optional<double> radius_with_triangles(std::span<const Point3> points, std::span<const Point3> normals,
                                                     const SurfaceOptions& options = {});

}  // namespace rbpa
