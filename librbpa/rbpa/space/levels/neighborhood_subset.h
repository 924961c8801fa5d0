// What: the points near a subset, as a point set of its own.
// Law:  a ball that touches a wanted point touches, holds and rests on the same points in the subset as in the whole set.
// Cost: a sort of the points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"

namespace rbpa::space {

struct NeighborhoodSubset {
  std::vector<std::uint32_t> input;  ///< input index of each point, ascending; equal points are in the subset together
  std::vector<Point3> points;
  std::vector<Point3> normals;  ///< empty when no normals were given
};

/// All points that a ball of the radius can touch or hold while it touches a point with wanted[index] != 0; the subset may have
/// more.
/// Requires: the duplicates of the points. Of equal points, wanted[stands_for] decides.
NeighborhoodSubset neighborhood_subset(std::span<const Point3> points, std::span<const Point3> normals,
                                       std::span<const Duplicate> duplicates, const std::vector<std::uint8_t>& wanted,
                                       double radius);

}  // namespace rbpa::space
