// What: finds the points that are in no triangle of a surface, and the reason for each.
// Law:  a function of the set of points, their normals and the radii; exact. docs/explanation/surfaces.md, sections 6
//       and 18.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// The reason why a point is in no triangle.
enum class UnusedCause : std::uint8_t {
  /// Balls without a point inside touch the point, but none touches two other points as well: other points are too far
  /// away, or on a line with the point.
  no_ball_rests,
  hidden,            ///< every ball of the largest radius that touches the point contains another point
  normals_disagree,  ///< the point is on exposed triangles, but each disagrees with a normal at a corner
  blocked,  ///< an exposed triangle at the point agrees, but touches the interior of the surface of smaller radii
  given_up  ///< reconstruct() has removed all triangles of the point to close the surface; not from unused_points()
};

/// A distinct point in no triangle.
struct UnusedPoint {
  std::uint32_t index;  ///< input index; of equal points the lowest
  UnusedCause cause;
  friend bool operator==(const UnusedPoint&, const UnusedPoint&) = default;
};

/// Returns the distinct points that are in no triangle, ascending. Surface::duplicates lists the points equal to them.
/// If the radii give several causes, the last one in the list of UnusedCause is returned.
/// Requires: `surface` is the surface() of these points, normals and radii; or, if `normals` is empty, the
///           exposed_triangles() of one radius. Only sizes, indices and gluing are checked.
/// Throws:   InvalidInput as surface() throws it; ContractViolation as require_linked() (triangle_arrays.h) throws it;
///           Cancelled.
/// Cost:     linear. As long as points have another cause than `blocked`, each radius also costs a sort of all points,
///           and the exposed triangles of the points near the unused ones.
RBPA_API std::vector<UnusedPoint> unused_points(std::span<const Point3> points, std::span<const Point3> normals,
                                                std::span<const double> radii, const Surface& surface,
                                                const SurfaceOptions& options = {});
/// Returns the unused points of a surface of one radius, as the function above does for several.
RBPA_API std::vector<UnusedPoint> unused_points(std::span<const Point3> points, std::span<const Point3> normals,
                                                double radius, const Surface& surface,
                                                const SurfaceOptions& options = {});

}  // namespace rbpa
