#include "rbpa/space/balls/union_of_balls.h"

#include <cmath>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/full/ball_parts.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/measure_balls.h"

namespace rbpa {
namespace {

std::vector<double> equal_radii(std::span<const Point3> points, double radius) {
  if (!(radius > 0) || std::isinf(radius))
    throw InvalidInput("union_of_balls: found the radius " + text(radius) + ", expected a finite number above 0");
  return std::vector<double>(points.size(), radius);
}

BallUnion total(const BallMeasures& measures) { return {measures.volume, measures.area}; }

}  // namespace

BallUnion union_of_balls(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                         double radius, unsigned wanted) {
  const std::vector<double> ball_radii = equal_radii(points, radius);
  meshops::require_one_each("union_of_balls", radii.size(), "radii", delaunay.simplices.size(), "tetrahedra");
  meshops::require(delaunay.neighbors.size() == radii.size() && !radii.empty(),
                   "union_of_balls: the triangulation has no tetrahedra or no neighbors, expected solid() at infinity");
  Threads threads = threads_for(points.size(), wanted);
  const space::Triangulated cells(points, delaunay);
  return total(space::ball_parts(cells, ball_radii, points.size(), {cells, radii, radius, threads}, {}, threads, {}));
}

BallUnion union_of_balls(std::span<const Point3> points, double radius, const SolidOptions& options) {
  return total(
      measure_balls(points, equal_radii(points, radius), {.threads = options.threads, .progress = options.progress}));
}

}  // namespace rbpa
