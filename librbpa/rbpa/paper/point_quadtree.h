// What:   the quadtree over the points, which gives the minimal radius of HRBPA.
// Law:    the tree depends on the set of points and the capacity alone.
// Cost:   O((d + 1) n) for depth d, as in the paper; d can reach two thousand.
// Source: Restricted BPA, section 6, "Minimal radius estimation", and figure 4.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa::paper {

struct Box {
  long double x, y;  ///< the lower left corner
  long double width, height;
};

/// Returns the least box around `points`. Requires: `points` is not empty.
Box box_of(std::span<const Point> points);

/// A square of the quadtree that is not cut.
struct Leaf {
  long double x, y;  ///< the lower left corner
  long double side;
  std::size_t points;  ///< number of points in the square
};

/// Returns the leaves of a quadtree. The root is the least square that covers the points' bounding box and has its
/// lower left corner. A square with more points than `capacity` is cut into quarters, unless long double has no
/// coordinate between its sides. A point on a cut is in the upper or right square.
/// Requires: at least one point; the points are distinct; capacity ≥ 1.
std::vector<Leaf> quadtree(std::span<const Point> points, std::size_t capacity);

/// Returns the minimal radius α₀: half the side of the smallest leaf, empty leaves included; the least double above 0
/// if this half rounds to 0. Requires: at least one leaf.
double minimal_radius(std::span<const Leaf> leaves);

}  // namespace rbpa::paper
