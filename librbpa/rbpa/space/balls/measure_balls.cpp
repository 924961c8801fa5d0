#include "rbpa/space/balls/measure_balls.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/full/ball_parts.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/far_points.h"
#include "rbpa/space/cells/check_input.h"

namespace rbpa {
namespace {

/// Measures balls on their triangulation. The balls from number `own` on are auxiliary.
BallMeasures measured(std::span<const Point3> centers, std::span<const double> radii, std::size_t own,
                      const RegularTriangulation& regular, const MeasureBallsOptions& options) {
  const GoOn go_on = go_on_of(options.progress, own);
  Threads threads = threads_for(own, options.threads);
  const space::Triangulated cells(centers, regular);
  return space::ball_parts(cells, radii, own, {cells, radii, threads, go_on}, options, threads, go_on);
}

std::vector<double> grown(std::span<const Point3> centers, std::span<const double> radii, double probe) {
  space::check_centers(centers, radii);
  std::vector<double> result(radii.begin(), radii.end());
  for (std::size_t i = 0; i < radii.size(); ++i) {
    result[i] += probe;
    if (!(result[i] >= 0) || std::isinf(result[i]))
      throw InvalidInput("radius " + std::to_string(i) + ": found " + text(radii[i]) + " with the probe " +
                         text(probe) + ", expected a finite sum of at least 0");
  }
  return result;
}

}  // namespace

BallMeasures measure_balls(std::span<const Point3> centers, std::span<const double> radii,
                           const RegularTriangulation& regular, const MeasureBallsOptions& options) {
  meshops::require_one_each("measure_balls", radii.size(), "radii", centers.size(), "centers");
  meshops::require(regular.neighbors.size() == regular.simplices.size() && !regular.simplices.empty(),
                   "measure_balls: the triangulation has no tetrahedra or no neighbors");
  return measured(centers, radii, centers.size(), regular, options);
}

BallMeasures measure_balls(std::span<const Point3> centers, std::span<const double> radii,
                           const MeasureBallsOptions& options) {
  std::vector<double> all_radii = grown(centers, radii, options.probe);
  if (centers.empty()) return {};
  const SolidOptions with_neighbors = {.threads = options.threads, .progress = options.progress};
  RegularTriangulation regular = regular_triangulation(centers, all_radii, with_neighbors);
  if (!regular.simplices.empty()) return measure_balls(centers, all_radii, regular, options);
  // All centers are in a plane. Additional balls of radius 0, too far away to meet any other, make a triangulation.
  const std::vector<Point3> all =
      space::with_far_points(centers, *std::max_element(all_radii.begin(), all_radii.end()));
  all_radii.resize(all.size(), 0);
  regular = regular_triangulation(all, all_radii, with_neighbors);
  return measured(all, all_radii, centers.size(), regular, options);
}

}  // namespace rbpa
