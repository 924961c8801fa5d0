#include "rbpa/space/solid/tiles/leaf_points.h"

#include <algorithm>
#include <cmath>

namespace rbpa::space {
namespace {

constexpr std::size_t beyond_end = 16;  // values in the longest register

double largest(const Box& box) {
  double size = 0;
  for (const Point3& p : {box.low, box.high}) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return size;
}

}  // namespace

bool Tile::gather(const Leaves& leaves, std::size_t number) {
  const Leaf& leaf = leaves[number];
  first_own_ = leaf.first;
  own_ = leaf.end - leaf.first;
  size_ = 0;
  grid_ = leaf.grid;
  const double side = grid_.size;
  // Rounded coordinates near a point must be in the cells of the exact ones, so cells must not be too small.
  if (!(side > 0x1p-40 * largest(leaf.box)) || grid_.inverse == 0) return false;
  for (std::size_t k = 0; k < 3; ++k) cells_[k] = leaf.cells[k] + 2 * margin;
  const auto cell_at = [&](int along, std::size_t axis) { return std::clamp(along + margin, -1, cells_[axis]); };
  const Box& all = leaves.box();
  filled_ = {{{cell_at(grid_.along_x(all.low.x), 0), cell_at(grid_.along_x(all.high.x), 0)},
              {cell_at(grid_.along_y(all.low.y), 1), cell_at(grid_.along_y(all.high.y), 1)},
              {cell_at(grid_.along_z(all.low.z), 2), cell_at(grid_.along_z(all.high.z), 2)}}};

  unsorted_.clear();
  cell_of_.clear();
  const std::size_t cells =
      static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]) * static_cast<std::size_t>(cells_[2]);
  start_.assign(cells + 1, 0);
  // The box is one cell larger than needed, because sums are rounded.
  const auto beyond = [&](double from, std::size_t axis) { return from + (leaf.cells[axis] + margin + 1) * side; };
  const double reach = (margin + 1) * side;
  const Point3& low = grid_.low;
  const Box around = {{low.x - reach, low.y - reach, low.z - reach},
                      {beyond(low.x, 0), beyond(low.y, 1), beyond(low.z, 2)}};
  const auto add = [&](Place first, Place end) {
    for (Place i = first; i < end; ++i) {
      const Point3& p = leaves.point(i);
      const int x = grid_.along_x(p.x) + margin, y = grid_.along_y(p.y) + margin, z = grid_.along_z(p.z) + margin;
      if (x < 0 || y < 0 || z < 0 || x >= cells_[0] || y >= cells_[1] || z >= cells_[2]) continue;
      const auto c = static_cast<std::uint32_t>(cell(x, y, z));
      unsorted_.push_back(i);
      cell_of_.push_back(c);
      ++start_[c];
    }
  };
  bool fits = own_ <= most_points;
  if (!fits) return false;
  leaves.for_each_leaf(around, [&](std::size_t i) {
    if (!fits) return;
    const Leaf& other = leaves[i];
    if (i == number) return add(other.first, other.end);
    if (other.first == other.end) return;
    // Find the cells of the other leaf that `around` meets.
    const CellGrid& grid = other.grid;
    const auto part = [](int from, int to, int count) {
      return Range{std::clamp(from, 0, count - 1), std::clamp(to, 0, count - 1)};
    };
    const Range xs = part(grid.along_x(around.low.x), grid.along_x(around.high.x), other.cells[0]),
                ys = part(grid.along_y(around.low.y), grid.along_y(around.high.y), other.cells[1]),
                zs = part(grid.along_z(around.low.z), grid.along_z(around.high.z), other.cells[2]);
    for (int x = xs.low; x <= xs.high && fits; ++x)
      for (int y = ys.low; y <= ys.high; ++y) {
        const std::size_t row =
            (static_cast<std::size_t>(x) * static_cast<std::size_t>(other.cells[1]) + static_cast<std::size_t>(y)) *
            static_cast<std::size_t>(other.cells[2]);
        add(leaves.first_in(other, row + static_cast<std::size_t>(zs.low)),
            leaves.first_in(other, row + static_cast<std::size_t>(zs.high) + 1));
        fits = unsorted_.size() <= most_points;
      }
  });
  if (!fits) return false;
  size_ = unsorted_.size();
  Local sum = 0;
  for (std::size_t c = 0; c < cells; ++c) start_[c] = sum += start_[c];
  start_[cells] = sum;
  for (auto* const values : {&x_, &y_, &z_})
    if (values->size() < size_ + beyond_end) values->resize(2 * size_ + beyond_end);
  if (place_.size() < size_) place_.resize(2 * size_);
  for (std::size_t k = size_; k-- > 0;) {
    const Local at = --start_[cell_of_[k]];
    const Point3& p = leaves.point(unsorted_[k]);
    x_[at] = p.x, y_[at] = p.y, z_[at] = p.z;
    place_[at] = unsorted_[k];
  }
  return true;
}

bool Tile::ranges(const Box& box, std::array<Range, 3>& of) const {
  const auto range = [&](int low, int high, std::size_t axis) {
    low = std::max(low + margin, filled_[axis].low);
    high = std::min(high + margin, filled_[axis].high);
    of[axis] = {std::max(low, 0), std::min(high, cells_[axis] - 1)};
    return low >= 0 && high < cells_[axis];
  };
  const bool x = range(grid_.along_x(box.low.x), grid_.along_x(box.high.x), 0),
             y = range(grid_.along_y(box.low.y), grid_.along_y(box.high.y), 1),
             z = range(grid_.along_z(box.low.z), grid_.along_z(box.high.z), 2);
  return x && y && z;
}

}  // namespace rbpa::space
