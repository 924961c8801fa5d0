// What:   pivots a ball over points in space, and returns the surface as arrays of indices in canonical order.
// Law:    a function of the set of points, their normals and the radius, not of any order, seed or thread. Every
//         decision is exact, on any finite input; ties are decided by the symbolic perturbation that CGAL uses.
//         docs/explanation/surfaces.md.
// Cost:   linear in the number of points; the cost of a point grows slowly with the number of points within two radii.
// Source: Bernardini et al., The ball-pivoting algorithm for surface reconstruction (1999); the definition is of alpha
//         shapes (Edelsbrunner and Mücke, 1994).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

/// Options of a computation on points or on a surface.
struct SurfaceOptions {
  MaxThreads threads = 0;
  /// Progress::triangles is the number of exposed triangles found up to now, or of new triangles while holes are
  /// filled; otherwise the number of given triangles, or 0 while points are searched.
  OnProgress progress = {};
};

/// Oriented triangles, and for each side the triangle on which the ball comes to rest when it rolls over the side.
/// Corners are input indices; of equal points, the lowest.
struct Surface {
  /// The value for no neighbor in `neighbors`.
  static constexpr std::uint32_t none = 0xffffffff;

  /// The triangles, counter-clockwise as the ball sees them, each with its least index first, in lexicographic order.
  /// Three points may form two triangles, one for each side.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Neighbor k of a triangle is the triangle to which the ball rolls over the side across from corner k, or none.
  /// Rolling back returns to the same triangle.
  std::vector<std::array<std::uint32_t, 3>> neighbors;
  /// For each triangle, the number, from 0, of the radius that created it. Filled in only by surface() of several radii
  /// (surface_levels.h) and functions that keep levels.
  std::vector<std::uint32_t> levels;
  std::vector<Duplicate> duplicates;  ///< points equal to one of lower index; ascending by index
  std::size_t distinct = 0;           ///< number of distinct points
};

/// Computes the exposed triangles E_r: a triangle is exposed if a ball of the radius, with no point inside, touches its
/// three corners from its positive side. The exposed triangles form a closed surface: no neighbor is `none`.
/// Requires: 0 < radius < infinity; finite points, fewer than 2^32 − 1.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API Surface exposed_triangles(std::span<const Point3> points, double radius, const SurfaceOptions& options = {});

/// Computes the surface A_r: the exposed triangles whose own normal has a positive scalar product with the normals of
/// all points at their corners. Two sides are glued if the ball rolls over each side to the triangle of the other.
/// Requires: what exposed_triangles() requires; a normal for each point, finite, of any length but 0.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API Surface surface(std::span<const Point3> points, std::span<const Point3> normals, double radius,
                         const SurfaceOptions& options = {});

}  // namespace rbpa
