#include "rbpa/plane/predicate/window.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rbpa {
namespace {

constexpr int width = largest_in_double - least_in_double;
// The range of exponents of bits in doubles: of the least bit of all, and one above the greatest.
constexpr int least_bit = -1074, end_bits = 1024;

/// Returns the least exponent of the window that has the most points; `most` becomes the number of these points,
/// without points at the origin.
int best_window(std::span<const Point> points, std::uint32_t& most) {
  std::array<std::int64_t, end_bits - least_bit + width + 2>
      more{};  // for each first exponent, the increase of the number of points
  for (const Point& p : points) {
    const Magnitude m = magnitude({&p, 1});
    if (p == Point{} || m.highest - m.lowest > width) continue;
    ++more[static_cast<std::size_t>(m.highest - width - least_bit + width)];
    --more[static_cast<std::size_t>(m.lowest - least_bit + width) + 1];
  }
  std::int64_t count = 0, best_count = -1;
  int best = 0;
  for (std::size_t i = 0; i < more.size(); ++i) {
    count += more[i];
    if (count <= best_count) continue;
    best_count = count;
    best = static_cast<int>(i) + least_bit - width;
  }
  most = static_cast<std::uint32_t>(best_count);
  return best;
}

}  // namespace

Radius Window::scaled(const Radius& alpha) const {
  if (alpha.is_infinite()) return alpha;
  const long double radius = std::ldexp(static_cast<long double>(alpha.value()), exponent);
  if (radius > std::ldexp(1.0L, bounds.above_all)) return Radius();
  return Radius(static_cast<double>(std::max(radius, std::ldexp(1.0L, bounds.below_all))));
}

Window window_of(std::span<const Point> points) {
  Window window;
  if (const Magnitude bound = magnitude_bound(points); fits_double(bound)) {
    window.bounds = radius_bounds(bound);
    return window;
  }
  const Magnitude all = magnitude(points);
  window.bounds = radius_bounds(all);
  if (fits_double(all)) return window;
  Magnitude inside = all;
  if (all.highest - all.lowest > width) {
    std::uint32_t most = 0;
    inside.lowest = best_window(points, most);
    inside.highest = inside.lowest + width;
    const bool is_worth_it = most >= points.size() / 2;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const Magnitude m = magnitude(points.subspan(i, 1));
      const bool is_inside = points[i] == Point{} || (m.lowest >= inside.lowest && m.highest <= inside.highest);
      if (!is_worth_it || !is_inside) window.beyond.push_back(i);
    }
  }
  // Centers the bits of the points between the bounds of double; the exponent is limited, so that 2^exponent is a
  // double itself.
  window.exponent = std::min(least_in_double + (width - (inside.highest - inside.lowest)) / 2 - inside.lowest, 1000);
  window.bounds = radius_bounds({inside.lowest + window.exponent, inside.highest + window.exponent});
  return window;
}

}  // namespace rbpa
