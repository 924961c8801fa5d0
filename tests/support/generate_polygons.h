// What: generates polygons with holes that are hard to fill.
// Law:  a polygon is a function of its number.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rbpa/plane/outline_polygons.h"
#include "support/random.h"
#include "support/triangle.h"

namespace rbpa_test {

struct PolygonCase {
  std::string name;
  Points points = {};
  std::vector<rbpa::Polygon> polygons = {};  ///< valid, and rings do not touch
  double size = 1;                           ///< edge length of triangles that gives some hundreds of them
  bool is_roomy = true;  ///< edges and distances between rings are longer than `size`, except at corners
};

/// Returns one of ten kinds in turn: stars with holes, combs, spirals, holes that nearly touch, slivers, collinear
/// vertices, far from the origin, polygons in holes, and tangles of points.
PolygonCase polygon_case(std::size_t number);

/// Returns rings, each through at most `points` integer points in a square of side `side`; most cross or touch
/// themselves.
PolygonCase random_rings(Random& random, int rings, int points, int side);

}  // namespace rbpa_test
