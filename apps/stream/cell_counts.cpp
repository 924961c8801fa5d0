#include "stream/cell_counts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rbpa::app {
namespace {

constexpr int least_exponent = -1074, greatest_exponent = 1023;

/// Multiplies a coordinate by 2^−exponent and rounds down. Two factors keep each of them within the range of double.
struct Scaling {
  explicit Scaling(int exponent)
      : first(std::ldexp(1.0, -exponent / 2)), second(std::ldexp(1.0, -exponent - -exponent / 2)) {}
  std::int64_t operator()(double value) const { return static_cast<std::int64_t>(std::floor(value * first * second)); }
  double first, second;
};

std::size_t hash(std::int64_t column, std::int64_t row) {
  auto h = static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15U;
  h ^= std::rotl(static_cast<std::uint64_t>(row) * 0xc2b2ae3d27d4eb4fU, 31);
  h *= 0x165667b19e3779f9U;
  return h ^ h >> 29U;
}

}  // namespace

CellCounts::CellCounts(std::size_t most) : most_(most), table_(64) {}

double CellCounts::side() const { return std::ldexp(1.0, exponent_); }

/// Sets the side of the cells so that the extent of the first points spans about 2^12 cells. The side may grow later.
void CellCounts::begin() {
  const double extent = std::max(greatest_.x / 2 - least_.x / 2, greatest_.y / 2 - least_.y / 2);
  constexpr int cells_across = 12;  // binary logarithm of the number of cells across the first points
  exponent_ = extent > 0 ? std::max(std::ilogb(extent) + 1 - cells_across, least_exponent) : least_exponent;
}

void CellCounts::add(std::span<const Point> points) {
  if (points.empty()) return;
  if (points_ == 0) least_ = greatest_ = points.front();
  for (const Point& p : points) {
    least_ = {std::min(least_.x, p.x), std::min(least_.y, p.y)};
    greatest_ = {std::max(greatest_.x, p.x), std::max(greatest_.y, p.y)};
  }
  if (points_ == 0) begin();
  const double largest =
      std::max({std::abs(least_.x), std::abs(least_.y), std::abs(greatest_.x), std::abs(greatest_.y)});
  // Limit the absolute value of a column or row number to 60 bits.
  constexpr int bits = 60;
  if (largest > 0 && std::ilogb(largest) - bits >= exponent_)
    grow_side(std::min(std::ilogb(largest) - bits + 1, greatest_exponent) - exponent_);
  points_ += points.size();
  std::size_t first = 0;
  while (first < points.size()) {
    const Scaling scaled(exponent_);
    const int exponent = exponent_;
    while (first < points.size() && exponent == exponent_) {
      const std::int64_t column = scaled(points[first].x), row = scaled(points[first].y);
      std::size_t last = first + 1;  // successive points are usually in one cell
      while (last < points.size() && scaled(points[last].x) == column && scaled(points[last].y) == row) ++last;
      add(column, row, last - first);
      first = last;
    }
  }
}

Cell* CellCounts::find(std::int64_t column, std::int64_t row) {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t at = hash(column, row) & mask;; at = (at + 1) & mask) {
    Cell& cell = table_[at];
    if (cell.count == 0 || (cell.column == column && cell.row == row)) return &cell;
  }
}

void CellCounts::add(std::int64_t column, std::int64_t row, std::uint64_t count) {
  Cell& cell = *find(column, row);
  if (cell.count == 0) {
    cell.column = column;
    cell.row = row;
    ++used_;
  }
  cell.count += count;
  while (used_ > most_ && exponent_ < greatest_exponent) grow_side(1);
  if (2 * used_ > table_.size()) rebuild(2 * table_.size(), 0);
}

void CellCounts::grow_side(int doublings) {
  exponent_ += doublings;
  rebuild(table_.size(), doublings);
}

void CellCounts::rebuild(std::size_t size, int doublings) {
  std::vector<Cell> before(size);
  before.swap(table_);
  used_ = 0;
  const int shift = std::min(doublings, 63);
  for (const Cell& cell : before) {
    if (cell.count == 0) continue;
    const std::int64_t column = cell.column >> shift, row = cell.row >> shift;
    Cell& larger = *find(column, row);
    if (larger.count == 0) ++used_;
    larger = {column, row, larger.count + cell.count};
  }
}

std::vector<Cell> CellCounts::cells() const {
  std::vector<Cell> found;
  found.reserve(used_);
  for (const Cell& cell : table_)
    if (cell.count > 0) found.push_back(cell);
  std::sort(found.begin(), found.end(),
            [](const Cell& a, const Cell& b) { return a.column != b.column ? a.column < b.column : a.row < b.row; });
  return found;
}

}  // namespace rbpa::app
