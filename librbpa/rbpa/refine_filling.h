// What:   the fillings of holes as fine as the surface around them, and as smooth: points are added inside them.
// How:    triangles that are large for the edges at their corners are split, and edges flipped until they are Delaunay (Liepa
//         2003); then the new points are moved, the old ones lying still, to where the mean curvature at them and along the rim is that of
//         the two rings outside, harmonic in between: the least sum of squared differences, by up to twenty rounds of a sparse system.
// Law:    a function of the points and triangles, of no order and no number of threads. Nothing new crosses anything, which
//         is tested exactly: where it would, the new points of that filling are not moved, and where that crosses as well,
//         there are none.
// Cost:   that of crossing_triangles(), one to three times; for a filling of n points about n^1.5.
// Source: Liepa, Filling holes in meshes (2003); Schneider and Kobbelt, Geometric fairing of irregular meshes for free-form surface
//         design (2001).
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

struct RefinedSurface {
  std::vector<Point3> points;  ///< that are added; their numbers go on where the points' end
  /// Of each the three points between which it was put, all of less number: for what points have besides coordinates.
  std::vector<std::array<std::uint32_t, 3>> between;
  Surface surface;           ///< without levels
  std::vector<bool> is_new;  ///< of each triangle, whether it fills a hole
  std::size_t smooth = 0;    ///< fillings whose new points are moved
  std::size_t flat = 0;      ///< that have new points where the filling was
  std::size_t coarse = 0;    ///< that stay as they are
};

/// A filling is what is connected of the triangles with is_new[t].
/// Requires: an indexable_surface() of the points; fewer than 2^31 points and triangles together with those that are added.
/// Throws:   InvalidInput; ContractViolation; Cancelled.
RBPA_API RefinedSurface refine_filling(std::span<const Point3> points, const Surface& surface,
                                       const std::vector<bool>& is_new, const SurfaceOptions& options = {});

/// Normals of points that are added behind others: of each the mean direction of those at the three points between which it was put,
/// a unit vector; where these cancel each other, the first. Requires: normals of the others, none of length 0.
RBPA_API std::vector<Point3> normals_between(std::span<const Point3> normals,
                                             std::span<const std::array<std::uint32_t, 3>> between);

}  // namespace rbpa
