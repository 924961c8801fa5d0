// What: differences of points in space as vectors of rational numbers.
#pragma once

#include "oracle/rational.h"
#include "rbpa/base/point3.h"
#include "support/vectors.h"

namespace rbpa_test {

/// Returns b − a.
inline Vector3<Rational> rational_from(const rbpa::Point3& a, const rbpa::Point3& b) {
  return {rational(b.x) - rational(a.x), rational(b.y) - rational(a.y), rational(b.z) - rational(a.z)};
}

}  // namespace rbpa_test
