// What: the points that are in no triangle of a surface, and why.
// Law:  a function of the set of points, their normals and the radii; exact. docs/surface_derivation.md, section 10.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa {

enum class UnusedCause : std::uint8_t {
  no_ball_rests,  ///< an empty ball that touches the point rests on no two others as well: they are too far, or on a line
  hidden,         ///< every ball of the largest radius that touches the point holds others
  normals_disagree,  ///< balls rest on it, on triangles none of which agrees with the normals at all of its corners
  blocked,           ///< one agrees, and touches the inside of what smaller radii have made
};

struct UnusedPoint {
  std::uint32_t index;  ///< of the input; of equal points the lowest
  UnusedCause cause;
  friend bool operator==(const UnusedPoint&, const UnusedPoint&) = default;
};

/// The distinct points that are in no triangle, ascending. (For repetitions see Surface::duplicates.) Of several causes, at
/// several radii, the one that is named last above.
/// Requires: what surface() made of these points, normals and radii; or exposed_triangles() of one radius, without normals.
/// Throws:   InvalidInput as they do; ContractViolation when a triangle is not of three of the points; Cancelled.
/// Cost:     for each radius, that of the exposed triangles of the points near to those unused.
RBPA_API std::vector<UnusedPoint> unused_points(std::span<const Point3> points, std::span<const Point3> normals,
                                                std::span<const double> radii, const Surface& surface,
                                                const SurfaceOptions& options = {});
RBPA_API std::vector<UnusedPoint> unused_points(std::span<const Point3> points, std::span<const Point3> normals,
                                                double radius, const Surface& surface,
                                                const SurfaceOptions& options = {});

}  // namespace rbpa
