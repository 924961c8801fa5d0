// What:   normals of points in space that have none: of the plane that fits the nearest points, all turned to one side.
// Law:    a function of the set of points: of no order, no thread, and of no power of two by which all are multiplied.
//         Equal points have equal normals. An estimate, in rounded numbers; docs/surface.md, section 3, says when it is wrong.
// Cost:   O(n log n); about 25 neighbors + 100 bytes a point at most.
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
  /// The plane is fitted to a point and so many others, the nearest, or all where there are fewer. Where triangles would be
  /// equilateral the two rings around a point are 18 others, where squares 24: fewer follow the noise, more round off edges
  /// and take in the other side of what is thin.
  std::size_t neighbors = 16;
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped.
  unsigned threads = 0;
  /// Called now and then, one call at a time but from any thread of the run, with no triangles; returning false cancels it.
  /// Empty: never called.
  std::function<bool(const Progress&)> progress = {};
};

/// Of each point the unit normal of the plane that fits it and its nearest others, in the sense of least squares.
/// Distances that are equal are told apart by coordinates, in lexicographic order.
///
/// Points that are connected, from one to one of its nearest others and so on, have normals on one side: turned along a
/// spanning tree, from edge to edge with the least doubt. One of them is turned outward: the extreme point in the first of
/// the directions +z, −z, +y, −y, +x, −x that is within 60 degrees of its plane's normal. So where no step errs
/// (docs/surface.md, section 3) a closed surface has normals that point outward, each component of it, also one inside
/// another; and a plane that is not too steep, upward.
///
/// Where the nearest points are on a line as far as double can tell, the normal is, of the directions across that line, the
/// one nearest to the z axis, or the y axis where the line is parallel to z; of a single point it is +z.
/// Requires: finite points, fewer than 2^32 − 1; at least 2 neighbors.
/// Throws:   InvalidInput naming what is not; Cancelled.
RBPA_API std::vector<Point3> estimate_normals(std::span<const Point3> points, const NormalOptions& options = {});

}  // namespace rbpa
