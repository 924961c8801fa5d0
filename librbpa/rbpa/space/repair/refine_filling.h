// What:   adds points to the fillings of holes until they are as fine and as smooth as the surface around them.
// How:    splits triangles that are large relative to the edges at their corners, and flips edges until they are
//         Delaunay (Liepa 2003). Then moves the new points so that the mean curvature along the rim is that of the two
//         rings of points outside, and so that the mean curvature inside is harmonic. This takes up to twenty rounds of
//         least squares, each a sparse system.
// Law:    a function of the points and triangles, not of any order or number of threads. No triangle of a filling with
//         added points crosses another, which is tested exactly: if one would, the added points of the filling are not
//         moved; if a crossing remains, the filling gets no points.
// Cost:   that of crossing_triangles(), mostly one to three times, at most 2k + 1 times for k fillings; for a filling
//         of n points about n^1.5.
// Source: Liepa, Filling holes in meshes (2003); Schneider and Kobbelt, Geometric fairing of irregular meshes for
//         free-form surface design (2001).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// Points that refining added inside fillings.
struct AddedPoints {
  std::vector<Point3> points = {};  ///< numbered from the number of given points on
  /// For each added point, the three points of lower numbers between which it lies: for interpolating attributes.
  std::vector<std::array<std::uint32_t, 3>> between = {};
  std::size_t smooth = 0;  ///< number of fillings whose added points were moved
};

struct RefinedSurface : AddedPoints {
  Surface surface;           ///< the refined surface; without levels
  std::vector<bool> is_new;  ///< for each triangle, whether it fills a hole
  std::size_t flat = 0;      ///< number of fillings whose added points were not moved
  std::size_t coarse = 0;    ///< number of fillings without added points
};

/// Refines each filling: each connected set of triangles t with is_new[t]. A filling with two vertices at one place
/// stays as it is. Refining a filling stops when about 2^20 points have been added to it.
/// Requires: `surface` is an indexable_surface() of `points`, which are finite; one flag for each triangle; fewer than
///           2^31 points and triangles, the added ones included.
/// Throws:   InvalidInput when a point is not finite; ContractViolation when another requirement is visibly not met;
///           Cancelled.
RBPA_API RefinedSurface refine_filling(std::span<const Point3> points, const Surface& surface,
                                       const std::vector<bool>& is_new, const SurfaceOptions& options = {});

/// Refines the fillings of `filled`: replaces filled.surface and filled.is_new; filled.holes stays. Returns the added
/// points.
/// Requires: what the overload above requires of its surface and flags.
/// Throws:   what the overload above throws; `filled` is then unchanged.
RBPA_API AddedPoints refine_filling(std::span<const Point3> points, FilledSurface& filled,
                                    const SurfaceOptions& options = {});

/// Returns a unit normal for each added point: the mean direction of the normals at the three points in its row of
/// `between`, or the first of the three if they cancel each other.
/// Requires: `normals` has the normals of the points that were not added, none of length 0 (not checked); each added
///           point lies between points of lower numbers.
/// Throws:   ContractViolation when the row of an added point contains its own number or a greater one.
RBPA_API std::vector<Point3> normals_between(std::span<const Point3> normals,
                                             std::span<const std::array<std::uint32_t, 3>> between);

}  // namespace rbpa
