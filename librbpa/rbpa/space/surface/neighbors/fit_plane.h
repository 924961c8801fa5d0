// What: fits a plane to a point and its nearest others, by the eigenvectors of their covariance (Eigen).
#pragma once

#include <cstddef>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"

namespace rbpa::space {

struct Plane {
  Point3 normal;
  /// Roundness of the points along the plane, the ratio of the two greater eigenvalues: 1 in a disc, 0 on a line.
  double roundness;
  /// Confidence in the plane, 1 − the ratio of the two smaller eigenvalues: 1 in a plane, 0 in a ball or on a line.
  double flatness;

  /// Returns whether the points determine the plane: whether roundness is at least 0.03. Roundness is 0.28 at the
  /// straight rim of a sheet, and about 0 on scan lines that are farther apart than eight points of a line reach.
  bool is_certain() const { return roundness >= 0.03; }
};

/// Fits a plane to point i and its neighbors: through their centroid, with the least sum of squared distances. The
/// normal has unit length and points to either side. If the points are on a line within the precision of double, the
/// normal is the direction across the line nearest to +z, or to +y if the line is parallel to z; for a single point,
/// the normal is +z. Differences are of type Real.
template <typename Real>
Plane fit_plane(const Neighborhoods& points, std::size_t i);

struct PlanesOfPoints {
  Neighborhoods near;
  std::vector<Point3> normals;   ///< normal of each plane, by position in `near`
  std::vector<double> flatness;  ///< Plane::flatness, by position in `near`
};

/// Fits a plane to each point and its `count` nearest others. If `count` is at least 8 and these points do not
/// determine a plane (Plane::is_certain()), uses a wider neighborhood (find_nearest()). Fewer than 8 others are too
/// often nearly on a line for this test. Calls go_on() as find_nearest() does. Requires: what find_nearest() requires.
template <typename Real>
PlanesOfPoints fit_planes(std::vector<Point3> points, std::size_t count, Threads& threads, const Checkpoint& go_on);

extern template Plane fit_plane<double>(const Neighborhoods&, std::size_t);
extern template Plane fit_plane<long double>(const Neighborhoods&, std::size_t);
extern template PlanesOfPoints fit_planes<double>(std::vector<Point3>, std::size_t, Threads&, const Checkpoint&);
extern template PlanesOfPoints fit_planes<long double>(std::vector<Point3>, std::size_t, Threads&, const Checkpoint&);

}  // namespace rbpa::space
