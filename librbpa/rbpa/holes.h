// What: the boundary curves of a surface of points in space, and why it ends there, side by side.
// Law:  a function of the points, their normals and the radii. The exposed triangles are a closed surface: so the ball always
//       comes to some triangle, and a side is boundary because that one is not in the surface. docs/surface_derivation.md, section 10.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa {

/// Why the surface does not go on where the ball rolls over its rim.
enum class RimCause : std::uint8_t {
  nothing_within_reach,  ///< the ball goes around to the back: to the same three points, or where no normal agrees
  normals_disagree,  ///< it comes to a triangle that disagrees with the normals at some corners, and agrees with others
  blocked,           ///< it comes to one that agrees, and touches the inside of what smaller radii have made
};

/// A boundary side of a triangle, and where the ball comes when it rolls over it.
struct RimEdge {
  std::uint32_t from = 0, to = 0;  ///< input indices, the triangle to the right
  std::uint32_t triangle = 0;      ///< of the surface
  std::uint32_t level = 0;         ///< of the radii the last one at which a ball rests on it: the ball meant here
  RimCause cause = RimCause::nothing_within_reach;
  std::array<std::uint32_t, 3> next = {};  ///< the exposed triangle to which the ball comes, least index first
  /// Of each corner of `next`: a normal there disagrees; or, when blocked, it is an interior point of the smaller radii.
  std::array<bool, 3> corners = {};
  /// When blocked, of each side of `next`, across from corner k: it is an interior edge of the smaller radii, between points
  /// that are not.
  std::array<bool, 3> sides = {};
  friend bool operator==(const RimEdge&, const RimEdge&) = default;
};

/// A boundary curve: of a hole, or of the rim of it all.
struct Hole {
  std::vector<RimEdge> edges;  ///< each begins where the one before ends, the first with the least (from, to, triangle)
  double length = 0;           ///< of all edges
  friend bool operator==(const Hole&, const Hole&) = default;
};

/// All boundary curves, by their first edges. A curve goes on at the same fan of triangles, where several are at a point.
/// Requires: what surface() made of these points, normals and radii.
/// Throws:   InvalidInput as surface(); ContractViolation when it is no surface of theirs, as far as is noticed; Cancelled.
/// Cost:     for each radius, that of the exposed triangles of the points near to the boundary.
RBPA_API std::vector<Hole> holes(std::span<const Point3> points, std::span<const Point3> normals,
                                 std::span<const double> radii, const Surface& surface,
                                 const SurfaceOptions& options = {});
RBPA_API std::vector<Hole> holes(std::span<const Point3> points, std::span<const Point3> normals, double radius,
                                 const Surface& surface, const SurfaceOptions& options = {});

}  // namespace rbpa
