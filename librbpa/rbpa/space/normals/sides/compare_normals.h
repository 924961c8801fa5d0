// What:   compares the normals at the ends of an edge of the graph of nearest points.
// Source: König and Gumhold, Consistent propagation of normal orientations in point clouds (2009), section 2.
#pragma once

#include "rbpa/base/point3.h"

namespace rbpa::space {

struct NormalComparison {
  double agreement;  ///< above 0 if normals are on one side, below 0 if on different sides, ±1 if certain
  double tilt;       ///< 0 where the edge lies in both planes, 2 where it is perpendicular to both
};

/// Returns the comparison of normal m at p with normal n at q, one of them reflected across the plane in the middle
/// between p and q. The normals at the ends of a circular arc are reflections of each other in that plane. So outward
/// normals agree both across a thin sheet and around a sharp edge. Requires: unit normals, p != q.
template <typename Real>
NormalComparison compare_normals(const Point3& p, const Point3& m, const Point3& q, const Point3& n) {
  const Real x = Real(q.x) - Real(p.x), y = Real(q.y) - Real(p.y), z = Real(q.z) - Real(p.z);
  const Real length = x * x + y * y + z * z;
  const Real along_m = x * m.x + y * m.y + z * m.z, along_n = x * n.x + y * n.y + z * n.z;
  const double product = m.x * n.x + m.y * n.y + m.z * n.z;
  return {product - static_cast<double>(2 * (along_m * along_n) / length),
          static_cast<double>((along_m * along_m + along_n * along_n) / length)};
}

inline Point3 turned(const Point3& n) { return {0.0 - n.x, 0.0 - n.y, 0.0 - n.z}; }

}  // namespace rbpa::space
