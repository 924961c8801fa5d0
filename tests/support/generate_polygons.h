// What: polygons with holes that are hard to fill.
// Law:  a function of the number.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rbpa/shape.h"
#include "support/random.h"
#include "support/triangle.h"

namespace rbpa_test {

struct PolygonCase {
  std::string name;
  Points points = {};
  std::vector<rbpa::Polygon> polygons = {};  ///< valid, and rings do not touch
  double size = 1;                           ///< of triangles, so that there are some hundreds
  bool is_roomy = true;  ///< edges and distances between rings are longer than that, corners excepted
};

/// Stars with holes, combs, spirals, holes that nearly touch, slivers, collinear vertices, far from the origin, polygons
/// in holes, and tangles of points: ten kinds, again and again.
PolygonCase polygon_case(std::size_t number);

/// A ring through integer points, at most as many, in a square of that side; mostly it crosses or touches itself.
PolygonCase random_rings(Random& random, int rings, int points, int side);

}  // namespace rbpa_test
