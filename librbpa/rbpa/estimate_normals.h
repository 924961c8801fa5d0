// What:   estimates normals for points in space: each is that of the plane that fits the nearest points, and all are turned
//         to one side of the surface.
// Law:    a function of the set of points, and of no order or thread; multiplying all points by a power of two changes nothing.
//         Equal points have equal normals, but where they have different viewpoints. An estimate, in rounded numbers; when it
//         is wrong: docs/surface.md, section 3.
// Cost:   O(n log n), on a scanner's lines about 30 times as much, on closed bodies thinner than the points are apart ten times;
//         at most about 25 neighbors + 100 bytes a point.
// Source: Hoppe, DeRose, Duchamp, McDonald, Stuetzle, Surface reconstruction from unorganized points (1992).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

struct NormalOptions {
  /// The plane is fitted to a point and this many nearest others, or all where there are fewer. The two rings around a point
  /// have 18 others in a triangular grid, 24 in a square one: fewer follow the noise, more round off edges and include the
  /// other side of thin parts.
  std::size_t neighbors = 16;
  /// Where the points were seen from: one place for all, or one for each point. Empty: unknown.
  std::span<const Point3> viewpoints = {};
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped.
  unsigned threads = 0;
  /// Called repeatedly, with no triangles, one call at a time but from any thread of the run. Returning false cancels the run.
  /// Empty: never called.
  std::function<bool(const Progress&)> progress = {};
};

/// For each point, the unit normal of the plane that fits it and its nearest others with the least sum of squared distances.
/// Equal distances are ordered by the points' coordinates. Where 8 or more are on about a line, as on a scanner's lines whose
/// distance is larger than that of eight points along them, the plane is fitted to as many of the nearest 16 times `neighbors`,
/// chosen far from each other.
///
/// Points that are connected through nearest others have normals on one side: they are turned along a minimum spanning tree
/// whose weights measure how uncertain the side is across an edge. The first is turned outward: the extreme point in the
/// first of the directions +z, −z, +y, −y, +x, −x that is within 60 degrees of its plane's normal. So where no step errs
/// (docs/surface.md, section 3) each component of a closed surface has normals that point outward, also one inside another;
/// and a plane that is not too steep, upward.
///
/// Where the two sides of a closed body are nearer to each other than the points are, that tree errs. There the outer shells of
/// the exposed_triangles() of balls of a few spacings decide.
///
/// With viewpoints each normal is turned toward its own instead, as by turn_toward().
///
/// Where the nearest points are on a line within the precision of double, the normal is the direction across the line that is
/// nearest to the z axis, or to the y axis if the line is parallel to z; for a single point it is +z.
/// Requires: finite points, fewer than 2^32 − 1; at least 2 neighbors; no viewpoint, one, or one for each point, finite.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API std::vector<Point3> estimate_normals(std::span<const Point3> points, const NormalOptions& options = {});

struct EstimatedNormals {
  std::vector<Point3> normals;
  std::vector<double> certainty;  ///< of each, in [0, 1]
};

/// A normal of a certainty below this is in doubt.
inline constexpr double least_certainty = 0.5;

/// The same with how sure each normal is: the lesser of
/// - how well its neighbors determine a plane: 1 less the ratio of the two least variances of their covariance; 1 in a plane, 0 in a
///   ball of points or on a line;
/// - how sure its side is. An edge of the spanning tree cuts the graph of nearest points in two; the other edges across this cut agree with
///   it or not, each weighted by how certain it is: 1 where all agree, 0 where half or more do not. The least such number on the way
///   from the first point counts. Where a ball decides, what it sees of the point from outside more than from inside, and on from there. With
///   viewpoints four times the cosine between normal and view, at most 1.
/// Cost: O(n log n) more, in one thread; measured, 0 to 16 % of the estimate by one thread.
RBPA_API EstimatedNormals estimate_normals_and_certainty(std::span<const Point3> points,
                                                         const NormalOptions& options = {});

/// Turns each normal to the side of its plane that the viewpoint is on; where that is in the plane, the first coordinate of
/// the normal that is not 0, of z, y, x in turn, becomes positive.
/// Requires: a normal for each point; one viewpoint, or one for each point; all finite. Throws: InvalidInput. Cost: linear.
RBPA_API void turn_toward(std::span<const Point3> points, std::span<const Point3> viewpoints,
                          std::span<Point3> normals);

}  // namespace rbpa
