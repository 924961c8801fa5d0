// What: numbers points along a space-filling curve, so that simplices near each other are near in memory.
// Law:  of equal points, the one of lowest index comes first: duplicates are the same after renaming.
// Cost: a sort.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

class CurveOrder {
 public:
  /// Requires: finite points. Throws what `checkpoint` throws.
  CurveOrder(std::span<const Point3> points, const Checkpoint& checkpoint);

  /// Returns what belongs to each point, in the order of the curve.
  template <typename Item>
  std::vector<Item> sorted(std::span<const Item> of_points) const {
    std::vector<Item> result(index_.size());
    for (std::size_t i = 0; i < index_.size(); ++i) result[i] = of_points[index_[i]];
    return result;
  }
  /// Renames all corners, and moves values of points, from places on the curve to input indices.
  void rename_corners(SolidFiltration& filtration) const;

 private:
  std::vector<std::uint32_t> index_;  // of the point at each place
};

}  // namespace rbpa::space
