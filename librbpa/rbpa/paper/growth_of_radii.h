// What:   HRBPA: RBPA with the radii α₀, 2α₀, 4α₀ … up to α, where each level continues the front of the level before.
// Law:    after each level the mesh is the solid alpha complex of the radius of the level.
// Cost:   the quadtree; for each level that adds a triangle, RBPA on the transferred points; for a sequence of k levels
//         that add no triangle, tests of about log k levels.
// Source: Restricted BPA, section 6.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "rbpa/paper/pivoting.h"

namespace rbpa::paper {

/// A level that has ended.
struct Level {
  int number;     ///< the index i of the level, from 0
  Radius radius;  ///< 2ⁱ α₀, or α on the last level
  bool is_last;
  std::size_t transferred;  ///< number of points that were isolated or on the boundary when the level began
  std::size_t advancing;    ///< number of halfedges of the front when the level began
};

/// Runs the levels on a front, and returns α₀. Calls level_ended(level), in ascending order, after each level that was
/// run, or tested without finding a triangle. Every boundary halfedge is frozen at this time. An exception of
/// level_ended() ends the run.
/// Requires: the requirements of rbpa() (pivoting.h); leaf_capacity ≥ 1.
double hrbpa(std::span<const Point> points, Radius alpha, std::size_t leaf_capacity, Front& front, Monitor& monitor,
             const std::function<void(const Level&)>& level_ended);

}  // namespace rbpa::paper
