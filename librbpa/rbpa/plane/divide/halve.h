// What:   two orders of points, and the division of points into halves.
// Law:    if one set comes before another in either order, a line separates them.
// Cost:   linear, and neither part is less than an eighth of the whole.
// Source: docs/explanation/plane.md, section 14.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/base/point.h"

namespace rbpa {

/// A point and its site number.
struct SitePoint {
  Point at;
  std::uint32_t site;
};

/// The lexicographic order along x, and the order along y: the order along x after a quarter turn. operator() has no
/// branch; with_rare_ties() has a branch that is mispredicted only where coordinates are often equal.
struct AlongX {
  bool operator()(const SitePoint& p, const SitePoint& q) const {
    return (p.at.x < q.at.x) | ((p.at.x == q.at.x) & (p.at.y < q.at.y));
  }
  bool with_rare_ties(const SitePoint& p, const SitePoint& q) const {
    if (p.at.x == q.at.x) [[unlikely]]
      return p.at.y < q.at.y;
    return p.at.x < q.at.x;
  }
};
struct AlongY {
  bool operator()(const SitePoint& p, const SitePoint& q) const {
    return (p.at.y < q.at.y) | ((p.at.y == q.at.y) & (p.at.x > q.at.x));
  }
  bool with_rare_ties(const SitePoint& p, const SitePoint& q) const {
    if (p.at.y == q.at.y) [[unlikely]]
      return p.at.x > q.at.x;
    return p.at.y < q.at.y;
  }
};

inline constexpr std::size_t few = 16;

/// Sorts at most `few` points. The new place of a point is the number of points that come before that point, counted
/// without a branch that could be mispredicted.
template <typename Order>
void sort_few(std::span<SitePoint> places, Order before) {
  std::array<std::size_t, few> rank;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::size_t before_it = 0;
    for (std::size_t j = 0; j < i; ++j) {
      const bool comes_first = before(places[j], places[i]);
      before_it += comes_first;
      rank[j] += !comes_first;
    }
    rank[i] = before_it;
  }
  std::array<SitePoint, few> sorted;
  for (std::size_t i = 0; i < places.size(); ++i) sorted[rank[i]] = places[i];
  std::copy_n(sorted.begin(), places.size(), places.begin());
}

/// A sample of points at equal distances in the sequence, 5 of fewer than 160 points and otherwise 15, to estimate the
/// longer side of the box and a middle point.
class Sample {
 public:
  explicit Sample(std::span<const SitePoint> places) : count_(places.size() < 32 * some ? some : many) {
    for (std::size_t i = 0; i < count_; ++i) place_[i] = places[(2 * i + 1) * places.size() / (2 * count_)];
    Point low = place_[0].at, high = low;
    for (std::size_t i = 1; i < count_; ++i) {
      low = {std::min(low.x, place_[i].at.x), std::min(low.y, place_[i].at.y)};
      high = {std::max(high.x, place_[i].at.x), std::max(high.y, place_[i].at.y)};
    }
    is_wide_ = high.x - low.x >= high.y - low.y;
  }

  /// Returns whether the sample is at least as wide as high.
  bool is_wide() const { return is_wide_; }

  /// Returns the median of the sample.
  template <typename Order>
  SitePoint middle(Order before) const {
    std::array<SitePoint, many> sorted = place_;
    sort_few(std::span<SitePoint>(sorted.data(), count_), before);
    return sorted[count_ / 2];
  }

 private:
  static constexpr std::size_t some = 5, many = 15;
  std::size_t count_;
  std::array<SitePoint, many> place_;
  bool is_wide_;
};

/// Divides the points into two parts, the first before the second in the order `before`, and returns the position at
/// which the second begins. Each part has at least ⌊n / 8⌋ of the n points. Requires: `sample` is of these points.
template <typename Order>
std::size_t halve(std::span<SitePoint> places, const Sample& sample, Order before) {
  const std::size_t n = places.size();
  const SitePoint pivot = sample.middle(before);
  std::size_t m = 0;
  for (SitePoint& p : places) {
    const SitePoint moved = p;
    p = places[m];
    places[m] = moved;
    m += before.with_rare_ties(moved, pivot);
  }
  if (m >= n / 8 && n - m >= n / 8) return m;
  std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(n / 2), places.end(), before);
  return n / 2;
}

}  // namespace rbpa
