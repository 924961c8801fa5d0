// What:   HRBPA: RBPA with the radii α₀, 2α₀, 4α₀ … up to α, each level going on with the front of the one before.
// Law:    after level i the mesh is the solid alpha complex of its radius.
// Cost:   that of the quadtree; of RBPA on the points carried on to each level with a triangle; and for a row of levels
//         without any, of looking at a logarithm of their number.
// Source: Restricted BPA, section 6.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "rbpa/paper/rbpa.h"

namespace rbpa::paper {

/// A level that has ended.
struct Level {
  int number;     ///< i
  Radius radius;  ///< 2ⁱ α₀, or α on the last
  bool is_last;
  std::size_t transferred;  ///< points: boundary and isolated ones
  std::size_t advancing;    ///< halfedges of the front when it began
};

/// Calls level_ended(level) after each level that was run or looked at in vain, ascending: every boundary halfedge is
/// frozen. What it throws ends the run.
/// Requires: what rbpa() does; leaf_capacity ≥ 1.
/// Returns:  α₀.
double hrbpa(std::span<const Point> points, Radius alpha, std::size_t leaf_capacity, Front& front, Monitor& monitor,
             const std::function<void(const Level&)>& level_ended);

}  // namespace rbpa::paper
