// What: finds the boundary curves of a surface of points in space, and for each edge why the surface ends there.
// Law:  a function of the points, their normals and the radii. The exposed triangles form a closed surface, so the ball
//       rolls over every side to an exposed triangle; over a boundary side, it rolls to one that is not in the surface.
//       docs/explanation/surfaces.md, sections 5 and 18.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// The reason why the surface ends at a boundary edge, given by the triangle to which the ball rolls over the edge.
enum class RimCause : std::uint8_t {
  /// The ball comes to rest on the back: on the same three points from the other side, or on a triangle with which
  /// normals at all corners disagree.
  nothing_within_reach,
  normals_disagree,  ///< the ball rolls to a triangle with which normals at one or two corners disagree
  /// The ball rolls to a triangle that agrees with all normals, but touches an interior point or interior edge of the
  /// surface of the smaller radii (surface_levels.h).
  blocked,
};

/// A boundary side of a triangle, and the triangle to which the ball rolls over the side. surface_curves() sets only
/// `from`, `to` and `triangle`.
struct RimEdge {
  std::uint32_t from = 0, to = 0;  ///< input indices, with the triangle to the right
  std::uint32_t triangle = 0;      ///< number of the triangle in the surface
  std::uint32_t level = 0;         ///< number, from 0, of the largest radius whose ball rests on the triangle
  RimCause cause = RimCause::nothing_within_reach;
  std::array<std::uint32_t, 3> next = {};  ///< exposed triangle to which that ball rolls, least index first
  /// For each corner of `next`: whether a normal there disagrees; if the cause is `blocked`, whether the corner is an
  /// interior point of the surface of the smaller radii.
  std::array<bool, 3> corners = {};
  /// For the side of `next` across from each corner, if the cause is `blocked`: whether the side is an interior edge of
  /// the surface of the smaller radii, and neither of its ends is an interior point.
  std::array<bool, 3> sides = {};
  friend bool operator==(const RimEdge&, const RimEdge&) = default;
};

/// A boundary curve: around a hole, or the outer rim.
struct Hole {
  std::vector<RimEdge> edges;  ///< edges in order along the curve, from the one with the least (from, to, triangle)
  double length = 0;           ///< sum of the lengths of the edges, in units of the points
  friend bool operator==(const Hole&, const Hole&) = default;
};

/// Returns all boundary curves, sorted by (from, to, triangle) of their first edges. A curve through a point with
/// several fans continues along one fan.
/// Requires: `surface` is the surface() of these points, normals and radii.
/// Throws:   InvalidInput as surface() throws it; ContractViolation when `surface` is visibly of other points, normals
///           or radii; Cancelled.
/// Cost:     for each radius, a sort of all points, a pass over the surface, and the exposed triangles of the points
///           near the boundary.
RBPA_API std::vector<Hole> holes(std::span<const Point3> points, std::span<const Point3> normals,
                                 std::span<const double> radii, const Surface& surface,
                                 const SurfaceOptions& options = {});
/// Returns the boundary curves of a surface of one radius, as the function above does for several.
RBPA_API std::vector<Hole> holes(std::span<const Point3> points, std::span<const Point3> normals, double radius,
                                 const Surface& surface, const SurfaceOptions& options = {});

/// Returns the boundary curves of any surface of `points`, in the order of holes(), without causes.
/// Throws: ContractViolation as require_linked() (triangle_arrays.h) throws it; Cancelled.
/// Cost:   linear, and a sort of the curves and of the edges of each curve.
RBPA_API std::vector<Hole> surface_curves(std::span<const Point3> points, const Surface& surface,
                                          const GoOn& go_on = {});

}  // namespace rbpa
