// What: the level of a triangle on sites, computed in the scale of the window of doubles if the triangle lies in the
//       window, otherwise in the scale of the input.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "meshops/patch/site.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/hierarchy/first_level.h"
#include "rbpa/plane/hierarchy/ladder.h"

namespace rbpa {

class SiteLevels {
 public:
  /// Keeps references to both arguments. Cost: linear in the levels.
  SiteLevels(const Sites& sites, const Ladder& ladder)
      : sites_(sites), ladder_(ladder), scaled_ladder_(ladder, sites.window()) {}

  /// Returns the first level whose radius admits the triangle. Requires: the last level's radius admits the triangle.
  int of(const std::array<meshops::Site, 3>& t) const {
    const std::span<const Point> points = sites_.grid().points();
    const std::size_t in_window = points.size();
    if (t[0] < in_window && t[1] < in_window && t[2] < in_window)
      return first_level<double>(points[t[0]], points[t[1]], points[t[2]], scaled_ladder_);
    return first_level<long double>(sites_.at(t[0]), sites_.at(t[1]), sites_.at(t[2]), ladder_);
  }

 private:
  const Sites& sites_;
  const Ladder& ladder_;
  ScaledLadder scaled_ladder_;
};

}  // namespace rbpa
