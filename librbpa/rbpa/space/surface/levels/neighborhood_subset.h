// What: selects the points near some wanted points, as a point set of its own.
// Law:  a ball that touches a wanted point touches and contains the same points in the subset as in the whole set.
// Cost: a sort of the points, once for any number of subsets with one radius.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/cells/cells.h"

namespace rbpa::space {

class NeighborhoodFinder {
 public:
  NeighborhoodFinder(std::span<const Point3> points, double radius);

  /// Returns the indices, ascending, of all points that a ball of the radius can touch or contain while it touches a
  /// wanted point, and possibly indices of further points. Of equal points, all or none are included.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> wanted) const;

 private:
  Cells cells_;
  std::vector<Site> site_;  // for each point, its site
};

struct NeighborhoodSubset {
  std::vector<std::uint32_t> input;  ///< input index of each point, ascending
  std::vector<Point3> points;
  std::vector<Point3> normals;  ///< empty when no normals were given
};

/// Returns the points that NeighborhoodFinder::around() finds for the distinct points i with wanted[i] != 0.
NeighborhoodSubset neighborhood_subset(std::span<const Point3> points, std::span<const Point3> normals,
                                       std::span<const Duplicate> duplicates, const std::vector<std::uint8_t>& wanted,
                                       double radius);

}  // namespace rbpa::space
