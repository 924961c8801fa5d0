// What: the triangles or tetrahedra that have a corner at a point.
// Cost: linear.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>

#include "meshops/core/fresh_vector.h"

namespace rbpa {

/// Returns the greatest corner plus one; 0 if there is no simplex.
template <std::size_t corners>
std::size_t corner_bound(std::span<const std::array<std::uint32_t, corners>> simplices) {
  std::size_t bound = 0;
  for (const auto& simplex : simplices)
    for (const std::uint32_t corner : simplex) bound = std::max(bound, corner + std::size_t{1});
  return bound;
}

template <std::size_t corners>
class SimplicesAt {
 public:
  SimplicesAt() = default;
  /// Sorts the simplices by corner. Requires: every corner is below `points`; not checked.
  SimplicesAt(std::span<const std::array<std::uint32_t, corners>> simplices, std::size_t points)
      : begin_(points + 2, 0) {
    // While simplices are put in place, begin_[p + 1] is the position of the next simplex at point p. It advances from
    // the begin to the end of the range of p, and thus becomes the begin of the range of p + 1.
    for (const auto& simplex : simplices)
      for (const std::uint32_t corner : simplex) ++begin_[corner + std::size_t{2}];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    simplices_.resize(begin_.back());
    for (std::uint32_t t = 0; t < simplices.size(); ++t)
      for (const std::uint32_t corner : simplices[t]) simplices_[begin_[corner + std::size_t{1}]++] = t;
  }

  /// Returns the indices of the simplices that have a corner at `point`, ascending. Requires: `point` is less than the
  /// number of points given to the constructor.
  std::span<const std::uint32_t> operator[](std::size_t point) const {
    return std::span(simplices_).subspan(begin_[point], begin_[point + 1] - begin_[point]);
  }

 private:
  meshops::FreshVector<std::size_t> begin_;  // for each point, the begin of its range in simplices_
  meshops::FreshVector<std::uint32_t> simplices_;
};

using TrianglesAt = SimplicesAt<3>;
using TetrahedraAt = SimplicesAt<4>;

}  // namespace rbpa
