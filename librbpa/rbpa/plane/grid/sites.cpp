#include "rbpa/plane/grid/sites.h"

#include <algorithm>
#include <utility>

namespace rbpa {
namespace {

/// Returns the grid of the points in the window.
PointGrid grid_of(std::span<const Point> input, const Window& window, Threads& threads, const Checkpoint& checkpoint) {
  if (window.exponent == 0 && window.beyond.empty()) return PointGrid(input, threads, checkpoint);
  const double scale = std::ldexp(1.0, window.exponent);
  std::vector<Point> scaled;
  std::vector<std::uint32_t> names;
  scaled.reserve(input.size() - window.beyond.size());
  names.reserve(input.size() - window.beyond.size());
  auto beyond = window.beyond.begin();
  for (std::uint32_t i = 0; i < input.size(); ++i) {
    if (beyond != window.beyond.end() && *beyond == i) {
      ++beyond;
      continue;
    }
    scaled.push_back({input[i].x * scale, input[i].y * scale});
    names.push_back(i);
  }
  return PointGrid(NamedPoints{scaled, names.data()}, threads, checkpoint);
}

}  // namespace

Sites::Sites(std::span<const Point> input, Threads& threads, const Checkpoint& checkpoint)
    : window_(window_of(input)),
      unscale_(std::ldexp(1.0, -window_.exponent)),
      grid_(grid_of(input, window_, threads, checkpoint)) {
  if (!window_.beyond.empty()) find_beyond(input);
}

void Sites::find_beyond(std::span<const Point> input) {
  std::vector<std::uint32_t> order = std::move(window_.beyond);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return input[i] == input[j] ? i < j : input[i] < input[j]; });
  index_.assign(grid_.input_index().begin(), grid_.input_index().end());
  std::vector<Point> places;
  // A place at distance `far` is outside of everything in the window, but differences of places are finite.
  constexpr double far = 0x1p200;
  const auto place = [&](double coordinate) {
    return static_cast<double>(
        std::clamp<long double>(std::ldexp(static_cast<long double>(coordinate), window_.exponent), -far, far));
  };
  for (const std::uint32_t i : order) {
    const Point& p = input[i];
    if (!beyond_.empty() && beyond_.back() == p) {
      repeated_beyond_.push_back({i, index_.back()});
      continue;
    }
    beyond_.push_back(p);
    index_.push_back(i);
    places.push_back({place(p.x), place(p.y)});
  }
  if (grid_.points().empty()) return;
  const auto& all = grid_.levels()[0];
  hidden_ = HiddenPoints(places, {{all.x, all.y}, {all.x + all.width, all.y + all.height}});
}

std::vector<Duplicate> Sites::duplicates() const {
  std::vector<Duplicate> all = grid_.duplicates();
  all.insert(all.end(), repeated_beyond_.begin(), repeated_beyond_.end());
  if (!repeated_beyond_.empty())
    std::sort(all.begin(), all.end(), [](const Duplicate& a, const Duplicate& b) { return a.index < b.index; });
  return all;
}

std::vector<Point> Sites::points() const {
  std::vector<Point> all(size());
  for (std::size_t s = 0; s < all.size(); ++s) all[s] = at(s);
  return all;
}

long double Sites::diameter_bound() const {
  if (beyond_.empty()) return std::ldexp(static_cast<long double>(grid_.diameter_bound()), -window_.exponent);
  using Real = long double;
  Point low = at(0), high = low;
  for (std::size_t s = 1; s < size(); ++s) {
    const Point p = at(s);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return 2 * (Real(high.x) - Real(low.x) + Real(high.y) - Real(low.y));
}

}  // namespace rbpa
