// What:   estimates normals of points in space: fits a plane to each point and its nearest others, and turns all
//         normals to one side of the surface, of closed surfaces outward.
// Law:    the normals depend on the set of points and their viewpoints only, not on any order or thread; multiplying
//         all points and viewpoints by a power of two changes no normal. Equal points have equal normals, unless their
//         viewpoints differ. The result is an estimate, in rounded numbers; docs/explanation/surfaces.md, section 3,
//         shows where it is wrong.
// Cost:   O(n log n) for points on surfaces; a third of it is the Delaunay triangulation. Three times as long for
//         points on the lines of a scanner. Memory: about 1200 bytes a point.
// Source: Hoppe, DeRose, Duchamp, McDonald, Stuetzle, Surface reconstruction from unorganized points (1992); for the
//         outer side those in docs/explanation/surfaces.md, section 19.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

struct NormalOptions {
  /// Number of nearest other points to which the plane is fitted, together with the point itself; all others if there
  /// are fewer. The two rings around a point have 18 others in a triangular grid, 24 in a square one. With fewer
  /// points, normals follow the noise; with more, edges are rounded off, and the other side of thin parts is included.
  std::size_t neighbors = 16;
  /// Viewpoints from which the points were seen: one for all points, or one for each. Empty if they are unknown.
  std::span<const Point3> viewpoints = {};
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is 0
};

/// Returns for each point the unit normal of the plane that fits the point and its nearest others with the least sum of
/// squared distances. Points at equal distances are ordered by their coordinates. A wider neighborhood is used if
/// `neighbors` is at least 8 and the nearest others are nearly on a line, as on the lines of a scanner that are farther
/// apart than eight points along a line. The plane is then fitted to as many points, chosen far from each other among
/// the nearest 8 · `neighbors` or, if the chosen ones are on a line too, among the nearest 16 · `neighbors`.
///
/// Components, connected through nearest others, that are closed surfaces have outward normals: away from the inside of
/// a body, and so into a cavity; of a body in the cavity again outward. The Delaunay tetrahedra around a point decide.
/// A normal that lies nearly in the surface, as of a plane fitted to both sides of a thin wall, is replaced. A
/// component counts as closed if at least 0.91 of what the tetrahedra say about it agrees, and if large triangles, with
/// an edge of more than four spacings, close less than a tenth of its area. None does if more than a tenth of the
/// points are along curves, or if squares of distances do not fit double.
///
/// The normals of other components, and those for which the tetrahedra do not decide, are turned to one side along a
/// minimum spanning tree, whose weights measure the uncertainty of the side across an edge. The first normal points
/// outward at the extreme point in one direction: the first of +z, −z, +y, −y, +x, −x that is within 60 degrees of the
/// normal of its extreme point, or else the direction nearest to the normal of its extreme point. The normals of a
/// plane that is not too steep point upward.
///
/// If there are viewpoints, each normal is turned by turn_toward() instead.
///
/// If the nearest points are on a line within the precision of double, the normal, before it is turned, is the
/// direction across the line that is nearest to the z axis, or to the y axis if the line is parallel to z. The normal
/// of a single distinct point is +z.
/// Requires: finite points, fewer than 2^32 − 1; at least 2 neighbors; no viewpoint, one, or one for each point,
///           finite.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API std::vector<Point3> estimate_normals(std::span<const Point3> points, const NormalOptions& options = {});

/// Normals with their confidence, in the order of the points.
struct EstimatedNormals {
  std::vector<Point3> normals;     ///< of unit length, one for each point
  std::vector<double> confidence;  ///< confidence in each normal, from 0 to 1
};

/// The confidence below which a normal counts as doubtful.
inline constexpr double least_confidence = 0.5;

/// Returns the normals of estimate_normals(), and the confidence in each, which is the lesser of two numbers:
/// - the confidence in the plane that fits the neighbors: 1 minus the ratio of the two least eigenvalues of the
///   neighbors' covariance; 1 in a plane, about 0 in a ball of points, 0 on a line;
/// - the confidence in the side. Each edge of the spanning tree cuts the graph of nearest points in two; the edges
///   across the cut vote whether the normals at their ends agree, each edge weighted by its own confidence. A cut
///   counts the share of the weight that agrees minus the share that does not, at least 0; the confidence is the least
///   cut on the path from the middle of the tree to the point. Where tetrahedra decide, the confidence is instead the
///   length, along the normal, of the mean of the unit normals of the facets between inside and outside around the
///   point. With viewpoints, the confidence in the side is four times the cosine of the angle between normal and view,
///   at most 1; 0 at the viewpoint itself.
/// Requires: what estimate_normals() requires.
/// Throws:   what estimate_normals() throws.
/// Cost:     O(n log n) in addition, in one thread; measured, 0 to 16 % of the estimate's time in one thread.
RBPA_API EstimatedNormals estimate_normals_and_confidence(std::span<const Point3> points,
                                                          const NormalOptions& options = {});

/// Turns each normal to the side of its plane on which the viewpoint is. If the viewpoint is in the plane, turns the
/// normal so that its first nonzero coordinate among z, y, x is positive.
/// Requires: a normal for each point; one viewpoint, or one for each point; all finite.
/// Throws:   InvalidInput when sizes do not fit or a viewpoint is not finite; no normal is then turned. Points and
///           normals are not checked.
/// Cost:     linear.
RBPA_API void turn_toward(std::span<const Point3> points, std::span<const Point3> viewpoints,
                          std::span<Point3> normals);

}  // namespace rbpa
