// What:   HRBPA: RBPA with the radii α₀, 2α₀, 4α₀ … up to α, where each level continues the front of the one before.
// Law:    after level i the mesh is the solid alpha complex of its radius.
// Cost:   the quadtree; RBPA on the points transferred to each level with a triangle; for a sequence of levels without
//         a triangle, tests of a logarithmic number of them.
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
  std::size_t transferred;  ///< number of points that are isolated or on the boundary
  std::size_t advancing;    ///< number of halfedges of the front when the level began
};

/// Runs the levels on a front. Calls level_ended(level) after each level that was run or searched in vain, ascending:
/// every boundary halfedge is then frozen. An exception that it throws ends the run.
/// Requires: as rbpa(); leaf_capacity ≥ 1.
/// Returns:  α₀.
double hrbpa(std::span<const Point> points, Radius alpha, std::size_t leaf_capacity, Front& front, Monitor& monitor,
             const std::function<void(const Level&)>& level_ended);

}  // namespace rbpa::paper
