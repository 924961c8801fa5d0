// What: numbers points along a space-filling curve, so that simplices near each other are near in memory.
// Law:  the first one of equal points is the point of lowest index, so that renaming does not change duplicates.
// Cost: a sort.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

class CurveOrder {
 public:
  /// Sorts the points along the curve. Requires: finite points. Throws what `checkpoint` throws.
  CurveOrder(std::span<const Point3> points, Threads& threads, const Checkpoint& checkpoint);

  /// Returns the items in the order of the curve. Requires: of_points[i] is the item of point i.
  template <typename Item>
  std::vector<Item> sorted(std::span<const Item> of_points) const {
    std::vector<Item> result(index_.size());
    for (std::size_t i = 0; i < index_.size(); ++i) result[i] = of_points[index_[i]];
    return result;
  }
  /// Replaces places on the curve by input indices in all corners, and sorts the values of points by input index.
  void rename_corners(Threads& threads, SolidFiltration& filtration) const;

 private:
  std::vector<std::uint32_t> index_;  // for each place on the curve, the input index of its point
};

}  // namespace rbpa::space
