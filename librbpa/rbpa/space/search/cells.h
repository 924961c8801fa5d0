// What: points of space in cells of about the ball's radius, those that have points only: on a surface most have none.
// Law:  every point within two radii of a point is in the 125 cells around its cell. For any exponents:
//       docs/surface.md, section 7. The order of the cells is a function of the set of points.
// Cost: a sort; as much memory as the points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/core/point3.h"

namespace rbpa::space {

class Cells {
 public:
  /// Requires: distinct finite points, fewer than 2^32; a finite radius above 0.
  Cells(std::span<const Point3> points, double radius);

  std::size_t size() const { return cells_.size() - 1; }
  /// The positions of the points in cell number i.
  std::span<const std::uint32_t> points_in(std::size_t i) const {
    return {order_.data() + cells_[i].first, order_.data() + cells_[i + 1].first};
  }
  /// Calls visit(number) for each cell around cell i, itself included, that has points.
  template <typename Visit>
  void for_each_around(std::size_t i, Visit visit) const {
    const Key key = cells_[i].key;
    for (std::int64_t x = key[0] - reach; x <= key[0] + reach; ++x)
      for (std::int64_t y = key[1] - reach; y <= key[1] + reach; ++y)
        for (std::size_t cell = first_not_before({x, y, key[2] - reach}); is_in_row(cell, x, y, key[2] + reach); ++cell)
          visit(cell);
  }

 private:
  using Key = std::array<std::int64_t, 3>;
  struct Cell {
    Key key;
    std::size_t first;
  };
  static constexpr std::int64_t reach = 2;

  std::size_t first_not_before(const Key& key) const;
  bool is_in_row(std::size_t cell, std::int64_t x, std::int64_t y, std::int64_t last) const {
    const Key& key = cells_[cell].key;  // the one for the end is there too
    return cell < size() && key[0] == x && key[1] == y && key[2] <= last;
  }

  std::vector<std::uint32_t> order_;
  std::vector<Cell> cells_;  // by key; and one for the end
};

}  // namespace rbpa::space
