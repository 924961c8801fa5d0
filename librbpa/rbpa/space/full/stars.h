// What: of each point the tetrahedra that it is a corner of.
// Cost: linear; four bytes for each corner of a tetrahedron.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rbpa::space {

class Stars {
 public:
  explicit Stars(std::span<const std::array<std::uint32_t, 4>> simplices) {
    std::size_t points = 0;
    for (const auto& row : simplices)
      for (const std::uint32_t corner : row) points = std::max(points, corner + std::size_t{1});
    first_.assign(points + 1, 0);
    for (const auto& row : simplices)
      for (const std::uint32_t corner : row) ++first_[corner + 1];
    for (std::size_t v = 0; v < points; ++v) first_[v + 1] += first_[v];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    tetrahedra_.resize(4 * simplices.size());
    for (std::uint32_t t = 0; t < simplices.size(); ++t)
      for (const std::uint32_t corner : simplices[t]) tetrahedra_[next[corner]++] = t;
  }

  /// One more than the greatest corner.
  std::size_t points() const { return first_.size() - 1; }
  /// Ascending.
  std::span<const std::uint32_t> at(std::size_t point) const {
    return std::span(tetrahedra_).subspan(first_[point], first_[point + 1] - first_[point]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> tetrahedra_;
};

}  // namespace rbpa::space
