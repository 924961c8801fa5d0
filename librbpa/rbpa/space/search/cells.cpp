#include "rbpa/space/search/cells.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace rbpa::space {
namespace {

/// Of two coordinates that differ by at most two radii the numbers differ by at most two.
std::int64_t number(double coordinate, double radius) {
  const long double quotient = std::floor(coordinate / (radius * (1 + 0x1p-6L)));
  if (std::abs(quotient) < 0x1p57L) return static_cast<std::int64_t>(quotient);
  // No other double is within two radii of it: only its equals need have the same number.
  return std::bit_cast<std::int64_t>(coordinate);
}

}  // namespace

Cells::Cells(std::span<const Point3> points, double radius) : order_(points.size()) {
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (const Point3& p : points) keys.push_back({number(p.x, radius), number(p.y, radius), number(p.z, radius)});
  std::iota(order_.begin(), order_.end(), std::uint32_t{0});
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
    return keys[i] != keys[j] ? keys[i] < keys[j] : points[i] < points[j];
  });
  for (std::size_t i = 0; i < order_.size(); ++i)
    if (i == 0 || keys[order_[i]] != cells_.back().key) cells_.push_back({keys[order_[i]], i});
  cells_.push_back({{}, order_.size()});
}

std::size_t Cells::first_not_before(const Key& key) const {
  const auto found = std::lower_bound(cells_.begin(), cells_.end() - 1, key,
                                      [](const Cell& cell, const Key& wanted) { return cell.key < wanted; });
  return static_cast<std::size_t>(found - cells_.begin());
}

}  // namespace rbpa::space
