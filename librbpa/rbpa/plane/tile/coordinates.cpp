#include "rbpa/plane/tile/coordinates.h"

#include <bit>
#include <cmath>
#include <limits>

namespace rbpa {
namespace {

/// Returns whether a − b is a double.
bool is_exact_difference(double a, double b) {
  const double difference = a - b, b_seen = a - difference, a_seen = difference + b_seen;
  return a - a_seen == 0 && b_seen - b == 0;
}

float lattice_extent(const Tile& tile, const Point& origin, double scale) {
  constexpr int digits = 24;  // 0x1p24 units to one
  std::uint32_t all = 0;
  const auto take = [&](double at, double from) {
    const double units = (at - from) * scale * 0x1p24;
    const auto whole = static_cast<std::int32_t>(units);
    all |= static_cast<std::uint32_t>(std::abs(whole));
    return double(whole) == units && is_exact_difference(at, from);
  };
  for (const Point& p : tile.points)
    if (!take(p.x, origin.x) || !take(p.y, origin.y)) return 0;
  // Differences of 11 bits have products of 22 bits, whose sums a float holds exactly.
  return all == 0 ? 0 : static_cast<float>(std::ldexp(1.0, std::countr_zero(all) - digits + 11));
}

}  // namespace

void TileCoordinates::assign(const Tile& tile) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const std::size_t n = tile.points.size();
  const Point origin = tile.points[n / 2];
  int exponent;
  std::frexp(std::max(tile.columns, tile.rows) * tile.cell, &exponent);
  scale = std::ldexp(1.0, -exponent);
  x.assign(n + padding, 0);
  y.assign(n + padding, 0);
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = static_cast<float>((tile.points[i].x - origin.x) * scale);
    y[i] = static_cast<float>((tile.points[i].y - origin.y) * scale);
  }
  lattice_extent = rbpa::lattice_extent(tile, origin, scale);

  columns = tile.columns;
  rows = tile.rows;
  cell = static_cast<float>(tile.cell * scale);
  per_cell = 1 / cell;
  x0 = static_cast<float>((tile.x0 - origin.x) * scale);
  y0 = static_cast<float>((tile.y0 - origin.y) * scale);
  x_low = tile.nothing_left ? -infinity : x0;
  y_low = tile.nothing_below ? -infinity : y0;
  x_high = tile.nothing_right ? infinity : static_cast<float>((tile.x1() - origin.x) * scale);
  y_high = tile.nothing_above ? infinity : static_cast<float>((tile.y1() - origin.y) * scale);

  const std::size_t size = tile.start.size() + 3 * static_cast<std::size_t>(columns);
  start.assign(tile.start.begin(), tile.start.end());
  start.resize(size, static_cast<std::int32_t>(n));
  unknown.assign(tile.unknown.begin(), tile.unknown.end());
  if (!unknown.empty()) unknown.resize(size, unknown.back());
}

bool TileCoordinates::is_known(int c0, int c1, int r0, int r1) const {
  if (unknown.empty()) return true;
  for (int r = r0; r <= r1; ++r) {
    const auto first = static_cast<std::size_t>(r * columns + c0),
               last = static_cast<std::size_t>(r * columns + c1 + 1);
    if (unknown[first] != unknown[last]) return false;
  }
  return true;
}

}  // namespace rbpa
