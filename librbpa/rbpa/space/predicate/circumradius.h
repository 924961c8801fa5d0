// What: the circumradius of four points, rounded up to a double.
// Law:  the least double that is not below it, for any finite points that are in no plane; infinity above all doubles.
// Cost: half a microsecond; some ten microseconds where double-double leaves two candidates, as for radii that are doubles.
#pragma once

#include "rbpa/base/point3.h"

namespace rbpa::space {

double circumradius_rounded_up(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace rbpa::space
