// What: points of the unit sphere along a spiral, about equally far from their neighbors, and points as text.
// Law:  a set is a function of its arguments.
#pragma once

#include <cmath>
#include <string>

#include "support/space_sets.h"

namespace rbpa_test {

/// Returns so many points of the unit sphere, from the greatest z to the least.
inline Points3 spiral(int count) {
  Points3 points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, around = i * 2.399963229728653, r = std::sqrt(1 - z * z);
    points.push_back({r * std::cos(around), r * std::sin(around), z});
  }
  return points;
}

/// Returns the coordinates with six digits behind the point and a blank between them.
inline std::string text_of(const rbpa::Point3& p) {
  return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
}

}  // namespace rbpa_test
