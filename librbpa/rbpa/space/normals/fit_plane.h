// What: the plane that fits a point and its nearest others, by the eigenvectors of their covariance (Eigen); those of all points.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/normals/find_nearest.h"

namespace rbpa::space {

struct Plane {
  Point3 normal;
  double roundness;  ///< of the points along it: 1 in a disc, 0 on a line; the ratio of the two greater eigenvalues
  double
      flatness;  ///< how well they determine it: 1 in a plane, 0 in a ball or on a line; 1 less the ratio of the two smaller ones

  /// The points determine it. At the straight rim of a sheet roundness is 0.28; on the lines of a scanner that are farther from
  /// each other than eight points along them it is about 0.
  bool is_certain() const { return roundness >= 0.03; }
};

/// A unit normal, to either side, of the plane through the centroid of point i and its neighbors that has the least sum of
/// squared distances from them. Where they are on a line within the precision of double, the direction across it that is
/// nearest to +z, or to +y if the line is parallel to z; for one point +z. Differences are of type Real.
template <typename Real>
Plane fit_plane(const Neighborhoods& points, std::size_t i);

struct PlanesOfPoints {
  Neighborhoods near;
  std::vector<Point3> normals;   ///< of fit_plane(), by positions in `near`
  std::vector<double> flatness;  ///< the same
};

/// The planes of points and their `count` nearest others. Where `count` is 8 or more and these are about on a line, of wider
/// neighborhoods (find_nearest()); fewer are often on one, and are kept. Requires and calls go_on() as find_nearest().
template <typename Real>
PlanesOfPoints fit_planes(std::vector<Point3> points, std::size_t count, Threads& threads,
                          const std::function<void()>& go_on);

extern template Plane fit_plane<double>(const Neighborhoods&, std::size_t);
extern template Plane fit_plane<long double>(const Neighborhoods&, std::size_t);
extern template PlanesOfPoints fit_planes<double>(std::vector<Point3>, std::size_t, Threads&,
                                                  const std::function<void()>&);
extern template PlanesOfPoints fit_planes<long double>(std::vector<Point3>, std::size_t, Threads&,
                                                       const std::function<void()>&);

}  // namespace rbpa::space
