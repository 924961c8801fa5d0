// What: the points near some of them, as a set of its own.
// Law:  a ball that touches one of those touches, holds and rests on the same points there as among all.
// Cost: a sort of the points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"

namespace rbpa::space {

struct Excerpt {
  std::vector<std::uint32_t> input;  ///< ascending; equal points together are in it, or not
  std::vector<Point3> points;
  std::vector<Point3> normals;  ///< none where there are none
};

/// What a ball of the radius can touch or hold that touches a point with wanted[index], and perhaps some more.
/// Requires: the duplicates of the points; of those, wanted[stands_for] is what counts.
Excerpt excerpt(std::span<const Point3> points, std::span<const Point3> normals, std::span<const Duplicate> duplicates,
                const std::vector<std::uint8_t>& wanted, double radius);

}  // namespace rbpa::space
