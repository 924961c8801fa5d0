// What: the plane that fits a point and its nearest others, by the eigenvectors of their covariance (Eigen).
#pragma once

#include <cstddef>

#include "rbpa/base/point3.h"
#include "rbpa/space/normals/find_nearest.h"

namespace rbpa::space {

struct Plane {
  Point3 normal;
  double roundness;  ///< of the points along it: 1 in a disc, 0 on a line; the ratio of the two greater eigenvalues

  /// The points determine it. At the straight rim of a sheet roundness is 0.28; on the lines of a scanner that are farther from
  /// each other than eight points along them it is about 0.
  bool is_certain() const { return roundness >= 0.03; }
};

/// A unit normal, to either side, of the plane through the centroid of point i and its neighbours that has the least sum of
/// squared distances from them. Where they are on a line within the precision of double, the direction across it that is
/// nearest to +z, or to +y if the line is parallel to z; for one point +z. Differences are of type Real.
template <typename Real>
Plane fit_plane(const Neighborhoods& points, std::size_t i);

extern template Plane fit_plane<double>(const Neighborhoods&, std::size_t);
extern template Plane fit_plane<long double>(const Neighborhoods&, std::size_t);

}  // namespace rbpa::space
