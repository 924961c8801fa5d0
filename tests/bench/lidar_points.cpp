#include "bench/lidar_points.h"

#include <algorithm>
#include <cmath>

namespace rbpa_bench {
namespace {

constexpr std::int64_t unit = 100;                                             // hundredths
constexpr std::int64_t easting = 450'000 * unit, northing = 5'400'000 * unit;  // coordinates of the first point
constexpr std::int64_t square = 32, lakes_apart = 1024;
constexpr double share_of_ground = 0.8;

/// Purposes of hashed numbers.
enum : std::uint64_t { place, of_gap, of_lake };

std::uint64_t mix(std::uint64_t h) {
  h = (h ^ h >> 30U) * 0xbf58476d1ce4e5b9U;
  h = (h ^ h >> 27U) * 0x94d049bb133111ebU;
  return h ^ h >> 31U;
}

/// Returns a number in [first, last] from 16 bits of a hash.
std::int64_t between(std::uint64_t bits, std::int64_t first, std::int64_t last) {
  return first + (static_cast<std::int64_t>(bits & 0xffffU) * (last - first + 1) >> 16U);
}

rbpa::Point point_at(std::int64_t x, std::int64_t y) {
  return {static_cast<double>(easting + x) / unit, static_cast<double>(northing + y) / unit};
}

}  // namespace

LidarPoints::LidarPoints(Ground ground, std::uint64_t count, std::uint64_t seed)
    : ground_(ground),
      left_(count),
      seed_(mix(seed + 0x9e3779b97f4a7c15U)),
      columns_(std::max<std::int64_t>(std::llround(std::sqrt(static_cast<double>(count) / share_of_ground)), 1)) {}

std::uint64_t LidarPoints::hash(std::uint64_t kind, std::int64_t column, std::int64_t row) const {
  return mix(mix(seed_ + kind + 4 * static_cast<std::uint64_t>(row)) + static_cast<std::uint64_t>(column));
}

/// Finds the disks that may overlap a square of side 32.
void LidarPoints::look_at_square(std::int64_t column, std::int64_t row) {
  if (column == square_column_ && row == square_row_) return;
  square_column_ = column;
  square_row_ = row;
  const auto middle = [](std::int64_t number, std::int64_t side) { return (number * side + side / 2) * unit; };
  gap_ = {};
  if (const std::uint64_t h = hash(of_gap, column, row);
      (h & 3U) == 0)  // one square in four has a gap, of radius 3 to 11
    gap_ = {middle(column, square) + between(h >> 16U, -4 * unit, 4 * unit),
            middle(row, square) + between(h >> 32U, -4 * unit, 4 * unit), between(h >> 48U, 3 * unit, 11 * unit)};
  const std::int64_t lake_column = column / (lakes_apart / square), lake_row = row / (lakes_apart / square);
  lake_ = island_ = {};
  if (const std::uint64_t h = hash(of_lake, lake_column, lake_row); (h & 1U) == 0) {
    lake_ = {middle(lake_column, lakes_apart), middle(lake_row, lakes_apart),
             between(h >> 16U, 150 * unit, 450 * unit)};
    island_ = {lake_.x, lake_.y, between(h >> 32U, 20 * unit, lake_.radius / 2)};
  }
}

bool LidarPoints::is_ground(std::int64_t x, std::int64_t y) {
  look_at_square(x / (square * unit), y / (square * unit));
  if (gap_.contains(x, y)) return false;
  return !lake_.contains(x, y) || island_.contains(x, y);
}

LidarPoints::Spot LidarPoints::jittered(std::int64_t column, std::int64_t row) const {
  const std::uint64_t h = hash(place, column, row);
  return {column * unit + between(h, 5, 95), row * unit + between(h >> 32U, 5, 95)};
}

void LidarPoints::make_row() {
  waiting_.clear();
  taken_ = 0;
  for (std::int64_t column = 0; column < columns_ && waiting_.size() < left_; ++column) {
    Spot spot{};
    if (ground_ == Ground::jittered) {
      spot = jittered(column, row_);
    } else {
      const std::uint64_t h = hash(place, column, row_);
      spot.x = static_cast<std::int64_t>((h >> 32U) * static_cast<std::uint64_t>(columns_ * unit) >> 32U);
      spot.y = row_ * unit + between(h, 0, unit - 1);
    }
    if (is_ground(spot.x, spot.y)) waiting_.push_back(point_at(spot.x, spot.y));
  }
  left_ -= waiting_.size();
  ++row_;
}

bool LidarPoints::next(std::vector<rbpa::Point>& block, std::size_t most) {
  block.clear();
  while (block.size() < most) {
    if (taken_ == waiting_.size()) {
      if (left_ == 0) break;
      make_row();
      continue;
    }
    const std::size_t some = std::min(most - block.size(), waiting_.size() - taken_);
    const auto first = waiting_.begin() + static_cast<std::ptrdiff_t>(taken_);
    block.insert(block.end(), first, first + static_cast<std::ptrdiff_t>(some));
    taken_ += some;
  }
  return !block.empty();
}

}  // namespace rbpa_bench
