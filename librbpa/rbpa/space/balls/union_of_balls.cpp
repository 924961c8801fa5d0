#include "rbpa/space/balls/union_of_balls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/full/ball_parts.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/far_points.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/solid/solid_radii.h"

namespace rbpa {
namespace {

/// Measures the union on one triangulation. Points from number `own` on have no ball.
BallUnion measured(std::size_t own, const space::Triangulated& cells, const space::FacesWithin& faces, double radius,
                   Threads& threads, const GoOn& go_on) {
  std::vector<double> radii(cells.positions.size(), radius);
  std::fill(radii.begin() + static_cast<std::ptrdiff_t>(own), radii.end(), 0.0);
  const BallMeasures found = space::ball_parts(cells, radii, own, faces, {}, threads, go_on);
  return {found.volume, found.area};
}

void check_radius(double radius) {
  if (!(radius > 0) || std::isinf(radius))
    throw InvalidInput("the radius is " + text(radius) + ", expected a finite number above 0");
}

}  // namespace

BallUnion union_of_balls(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                         double radius, unsigned wanted) {
  check_radius(radius);
  meshops::require_one_each("union_of_balls", radii.size(), "radii", delaunay.simplices.size(), "tetrahedra");
  meshops::require(delaunay.neighbors.size() == radii.size() && !radii.empty(),
                   "union_of_balls: the triangulation has no tetrahedra or no neighbors, expected solid() at infinity");
  Threads threads = threads_for(points.size(), wanted);
  const space::Triangulated cells(points, delaunay);
  return measured(points.size(), cells, {cells, radii, radius, threads}, radius, threads, {});
}

BallUnion union_of_balls(std::span<const Point3> points, double radius, const SolidOptions& options) {
  check_radius(radius);
  space::check_points(points);
  if (points.empty()) return {};
  SolidOptions with_neighbors = options;
  with_neighbors.neighbors = true;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Solid delaunay = solid(points, infinity, with_neighbors);
  std::vector<Point3> more;
  if (delaunay.simplices.empty()) {
    // All points are in a plane. Additional points, too far away for any ball to reach them, make a triangulation.
    more = space::with_far_points(points, radius);
    delaunay = solid(more, infinity, with_neighbors);
  }
  const std::span<const Point3> all = more.empty() ? points : std::span<const Point3>(more);
  const GoOn go_on = go_on_of(options.progress, points.size());
  const std::vector<double> radii = circumradii(all, delaunay.simplices, options.threads, go_on);
  Threads threads = threads_for(points.size(), options.threads);
  const space::Triangulated cells(all, delaunay);
  return measured(points.size(), cells, {cells, radii, radius, threads, go_on}, radius, threads, go_on);
}

}  // namespace rbpa
