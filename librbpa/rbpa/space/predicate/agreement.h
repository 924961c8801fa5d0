// What: whether triangles agree with the normals at their corners.
// Law:  exact. At a corner count the normals of all points that are there.
// Cost: as TriangleNormal, for each normal.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/core/duplicate.h"
#include "rbpa/core/point3.h"
#include "rbpa/space/predicate/normal_sign.h"

namespace rbpa::space {

class Agreement {
 public:
  /// Keeps the spans. Requires: the duplicates among the points; a normal of each, or none at all: then all agrees.
  Agreement(std::span<const Point3> points, std::span<const Point3> normals, std::span<const Duplicate> duplicates)
      : points_(points), normals_(normals), duplicates_(duplicates.begin(), duplicates.end()) {
    std::sort(duplicates_.begin(), duplicates_.end(), [](const Duplicate& d, const Duplicate& e) {
      return d.stands_for != e.stands_for ? d.stands_for < e.stands_for : d.index < e.index;
    });
  }

  /// Of each corner of an oriented triangle with a normal, whether one of the normals there has no positive product with its own.
  std::array<bool, 3> disagreeing(const std::array<std::uint32_t, 3>& triangle) const {
    std::array<bool, 3> result = {false, false, false};
    if (normals_.empty()) return result;
    const TriangleNormal normal(points_[triangle[0]], points_[triangle[1]], points_[triangle[2]]);
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = normal.sign_along(normals_[triangle[k]]) <= 0;
      const auto others =
          std::equal_range(duplicates_.begin(), duplicates_.end(), Duplicate{0, triangle[k]},
                           [](const Duplicate& d, const Duplicate& e) { return d.stands_for < e.stands_for; });
      for (auto other = others.first; other != others.second; ++other)
        result[k] = result[k] || normal.sign_along(normals_[other->index]) <= 0;
    }
    return result;
  }

 private:
  std::span<const Point3> points_, normals_;
  std::vector<Duplicate> duplicates_;  // by what they stand for
};

}  // namespace rbpa::space
