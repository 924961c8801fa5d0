// What: finds the nearest others of each point of a set, by the k-d tree of nanoflann. If the nearest others are on one
//       line, as on the lines of a scanner, chooses points farther from each other.
// Law:  nearest others are ordered by rounded squared distance, then lexicographically. Points are renumbered in the
//       order of the tree's leaves, so that near points have near numbers. A function of the set of points.
// Cost: O(n log n); about 30 times as much at points with a wider search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa::space {

struct Neighborhoods {
  std::vector<Point3> points;          ///< in the order of the leaves
  std::vector<std::uint32_t> place;    ///< the position in `points` of each input point
  std::size_t count = 0;               ///< number of nearest others per point
  std::vector<std::uint32_t> nearest;  ///< positions in `points`: `count` for each point, by ascending distance

  std::span<const std::uint32_t> around(std::size_t i) const { return {nearest.data() + i * count, count}; }
};

/// A function that returns whether the points around point i span a plane. It is called from any thread, at least once
/// for each i. The last call for i sees the final neighborhood.
using SpansPlane = std::function<bool(const Neighborhoods&, std::size_t i)>;

/// Returns the `count` nearest others of each point, or all others if there are fewer. Differences and squares are of
/// type Real. If the nearest others do not span a plane, the result has `count` of the nearest 8 · count, or else of
/// the nearest 16 · count: the two nearest, and others that are far from each other. If none of these choices spans a
/// plane, the result has the nearest others. Calls go_on(), if it is set, repeatedly, one call at a time.
/// Requires: distinct points, ascending, at least one; no square of a difference overflows, or underflows to 0.
template <typename Real>
Neighborhoods find_nearest(std::vector<Point3> points, std::size_t count, Threads& threads, const Checkpoint& go_on,
                           const SpansPlane& spans_plane = {});

/// Returns the spacing: the median over all points of the mesh width of a square grid that has as many points per area
/// as the neighborhood of the point.
/// Requires: at least one point, with nearest others.
double spacing_of(const Neighborhoods& near);

extern template Neighborhoods find_nearest<double>(std::vector<Point3>, std::size_t, Threads&, const Checkpoint&,
                                                   const SpansPlane&);
extern template Neighborhoods find_nearest<long double>(std::vector<Point3>, std::size_t, Threads&, const Checkpoint&,
                                                        const SpansPlane&);

}  // namespace rbpa::space
