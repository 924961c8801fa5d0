// What: the nearest others of each point of a set, by the k-d tree of nanoflann; where these are on one line, as on the lines of
//       a scanner, others that are farther from each other.
// Law:  nearest by rounded squared distances, and of equal ones the lexicographically least points. Points are renumbered in
//       the order of the tree's leaves, near ones together: a function of the set of points.
// Cost: O(n log n); about 30 times that at points where wider neighborhoods are looked at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"

namespace rbpa::space {

struct Neighborhoods {
  std::vector<Point3> points;          ///< in the order of the leaves
  std::vector<std::uint32_t> place;    ///< the position in `points` of each given point
  std::size_t count = 0;               ///< nearest others per point
  std::vector<std::uint32_t> nearest;  ///< positions in `points`: `count` of each point, by ascending distance

  std::span<const std::uint32_t> around(std::size_t i) const { return {nearest.data() + i * count, count}; }
};

/// Whether the points around point i determine a plane; called from any thread, at least once for each i, and last with what it
/// has around it in the end.
using SpansPlane = std::function<bool(const Neighborhoods&, std::size_t i)>;

/// The `count` nearest others of each, or all where there are fewer. Differences and squares are of type Real. Where these do not
/// span a plane, as many of the nearest 8 or 16 `count`, the nearest two and others that are far from each other; but the nearest
/// again where those do not either.
/// Calls go_on() repeatedly, if there is one, one call at a time.
/// Requires: distinct points, ascending, at least one; no square of a difference overflows, or underflows to 0.
template <typename Real>
Neighborhoods find_nearest(std::vector<Point3> points, std::size_t count, Threads& threads,
                           const std::function<void()>& go_on, const SpansPlane& spans_plane = {});

/// The median over the points of the distance between neighbors: where as many points per area are in a square grid.
/// Requires: points, with nearest others.
double spacing_of(const Neighborhoods& near);

extern template Neighborhoods find_nearest<double>(std::vector<Point3>, std::size_t, Threads&,
                                                   const std::function<void()>&, const SpansPlane&);
extern template Neighborhoods find_nearest<long double>(std::vector<Point3>, std::size_t, Threads&,
                                                        const std::function<void()>&, const SpansPlane&);

}  // namespace rbpa::space
