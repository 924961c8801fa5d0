// What: the triangles with a corner at a point, or a vertex.
// Cost: linear.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace rbpa::space {

class TrianglesAt {
 public:
  TrianglesAt() = default;
  /// Requires: corners below `points`.
  TrianglesAt(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t points) : begin_(points + 2, 0) {
    // begin_[p + 1] is where those of p begin, until each that is put there has moved it to where they end.
    for (const auto& triangle : triangles)
      for (const std::uint32_t corner : triangle) ++begin_[corner + 2];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    triangles_.resize(begin_.back());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (const std::uint32_t corner : triangles[t]) triangles_[begin_[corner + 1]++] = t;
  }

  /// Ascending.
  std::span<const std::uint32_t> operator[](std::uint32_t point) const {
    return std::span(triangles_).subspan(begin_[point], begin_[point + 1] - begin_[point]);
  }

 private:
  std::vector<std::uint32_t> begin_, triangles_;  // by point
};

}  // namespace rbpa::space
