// What: the plane that fits a point and its nearest others, by the eigenvectors of their covariance (Eigen).
#pragma once

#include <cstddef>

#include "rbpa/base/point3.h"
#include "rbpa/space/normals/find_nearest.h"

namespace rbpa::space {

/// A unit normal of the plane through the centroid of point i and those around it from which their distances have the least
/// sum of squares; on either side. Where they are on a line as far as double can tell, the direction across it that is
/// nearest to +z, or to +y where the line is parallel to z; of one point +z. Differences are of type Real.
template <typename Real>
Point3 fit_plane(const Neighborhoods& points, std::size_t i);

extern template Point3 fit_plane<double>(const Neighborhoods&, std::size_t);
extern template Point3 fit_plane<long double>(const Neighborhoods&, std::size_t);

}  // namespace rbpa::space
