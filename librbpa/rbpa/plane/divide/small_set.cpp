#include "rbpa/plane/divide/small_set.h"

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <vector>

#include "rbpa/plane/arrays/keep_triangles.h"
#include "rbpa/plane/divide/delaunay_edges.h"
#include "rbpa/plane/predicate/window.h"

namespace rbpa {
namespace {

using Edge = QuadEdges::Edge;

/// A hash table of points, which finds equal points.
class DistinctPoints {
 public:
  explicit DistinctPoints(std::span<const Point> points)
      : points_(points),
        shift_(64 - static_cast<int>(std::bit_width(2 * points.size() + 1))),
        slots_(std::size_t{1} << (64 - shift_), empty) {}

  /// Returns the index of an equal point that was added before; if there is none, adds point i and returns i.
  std::uint32_t add(std::uint32_t i) {
    std::size_t slot = hash(points_[i]);
    while (slots_[slot] != empty) {
      if (points_[slots_[slot]] == points_[i]) return slots_[slot];
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = static_cast<std::uint16_t>(i);
    return i;
  }

 private:
  static constexpr std::uint16_t empty = 0xffff;
  static_assert(small_set_limit < empty);

  std::size_t hash(const Point& p) const {
    // Adding 0 turns −0 into 0: equal points have equal hashes.
    const auto x = std::bit_cast<std::uint64_t>(p.x + 0.0), y = std::bit_cast<std::uint64_t>(p.y + 0.0);
    const std::uint64_t mixed = (x * 0x9e3779b97f4a7c15u) ^ std::rotl(y * 0xc2b2ae3d27d4eb4fu, 29);
    return (mixed * 0xff51afd7ed558ccdu) >> shift_;
  }

  std::span<const Point> points_;
  int shift_;
  std::vector<std::uint16_t> slots_;
};

/// The kept triangles, sorted by smallest corner and then by the next one.
class SortedTriangles {
 public:
  SortedTriangles(std::span<const SitePoint> places, QuadEdges& edges, std::size_t points)
      : places_(places),
        edges_(edges),
        found_(std::make_unique_for_overwrite<Found[]>(2 * places.size())),
        first_(points + 1, 0) {}

  /// Finds the triangles for which `admits` returns true.
  template <typename Admits>
  void find(const Admits& admits) {
    // Use two loops: the processor mispredicts branches only in the second.
    const auto least = std::make_unique_for_overwrite<Edge[]>(edges_.size());
    std::size_t triangles = 0;
    for (Edge s = 0; s < edges_.size(); ++s) {
      const Edge t = edges_.lnext(s), u = edges_.lnext(t);
      least[triangles] = s;
      triangles += static_cast<std::size_t>(s < t) & static_cast<std::size_t>(s < u);
    }
    for (std::size_t k = 0; k < triangles; ++k) {
      std::array<Edge, 3> side = {least[k], edges_.lnext(least[k]), 0};
      side[2] = edges_.lnext(side[1]);
      const std::array<const SitePoint*, 3> at = {&places_[edges_.org(side[0])], &places_[edges_.org(side[1])],
                                                  &places_[edges_.org(side[2])]};
      const bool is_kept = admits(at[0]->at, at[1]->at, at[2]->at);
      const int number = is_kept ? static_cast<int>(size_) : DelaunayEdges<double>::no_triangle;
      for (const Edge edge : side) edges_.number(edge, number);
      if (!is_kept) continue;
      const std::size_t i =
          at[0]->site < at[1]->site ? (at[0]->site < at[2]->site ? 0 : 2) : (at[1]->site < at[2]->site ? 1 : 2);
      ++first_[at[i]->site + 1];
      found_[size_++] = {{at[i]->site, at[(i + 1) % 3]->site, at[(i + 2) % 3]->site}, side[i]};
    }
  }

  /// Fills in triangles in canonical order, and neighbors unless `neighbors` is null; called once, after find().
  void sort(std::vector<Triangle>& triangles, std::vector<Triangle>* neighbors) {
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    const auto order = std::make_unique_for_overwrite<std::uint32_t[]>(size_);
    // Each triangle is inserted among the triangles with the same least corner, which are few, by its second corner.
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < size_; ++t) {
      const std::uint32_t corner = found_[t].corners[0];
      std::uint32_t at = next[corner]++;
      for (; at > first_[corner] && found_[order[at - 1]].corners[1] > found_[t].corners[1]; --at)
        order[at] = order[at - 1];
      order[at] = t;
    }
    triangles.resize(size_);
    for (std::size_t k = 0; k < size_; ++k) triangles[k] = found_[order[k]].corners;
    if (!neighbors) return;
    const auto rank = std::make_unique_for_overwrite<std::uint32_t[]>(size_);
    for (std::uint32_t k = 0; k < size_; ++k) rank[order[k]] = k;
    const auto across = [&](Edge side) {
      const int number = edges_.number(QuadEdges::sym(side));
      return number < 0 ? AlphaComplex::none : rank[static_cast<std::size_t>(number)];
    };
    neighbors->resize(size_);
    for (std::size_t k = 0; k < size_; ++k) {
      const Edge first = found_[order[k]].first_side, second = edges_.lnext(first), third = edges_.lnext(second);
      (*neighbors)[k] = {across(second), across(third), across(first)};
    }
  }

  std::size_t size() const { return size_; }

 private:
  struct Found {
    Triangle corners;
    Edge first_side;  // from corner 0 to corner 1
  };

  std::span<const SitePoint> places_;
  QuadEdges& edges_;
  std::unique_ptr<Found[]> found_;
  std::size_t size_ = 0;
  // For each point, and after the last, the position of the first triangle whose least corner is the point; before
  // sort(), the number of triangles whose least corner is the point before.
  std::vector<std::uint32_t> first_;
};

}  // namespace

bool triangulate_small_set(std::span<const Point> points, double alpha, const AlphaComplexOptions& options,
                           AlphaComplex& result) {
  const Magnitude bound = magnitude_bound(points);
  if (!fits_double(bound)) return false;
  std::vector<SitePoint> places;
  places.reserve(points.size());
  DistinctPoints distinct(points);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::uint32_t original = distinct.add(i);
    if (original == i)
      places.push_back({points[i], i});
    else
      result.duplicates.push_back({i, original});
  }
  result.distinct = places.size();
  const Radius radius = Window{.exponent = 0, .beyond = {}, .bounds = radius_bounds(bound)}.scaled(Radius::of(alpha));
  if (places.size() >= 3) {
    DelaunayEdges<double> delaunay(places, nullptr, {});
    SortedTriangles triangles(places, delaunay.edges(), points.size());
    if (radius.is_infinite())
      triangles.find([](const Point&, const Point&, const Point&) { return true; });
    else
      triangles.find([&](const Point& a, const Point& b, const Point& c) { return radius.admits<double>(a, b, c); });
    triangles.sort(result.triangles, options.neighbors || options.boundary ? &result.neighbors : nullptr);
  }
  result.isolated = isolated_in(result, points.size());
  stop_if_cancelled(options.progress, {result.triangles.size(), result.distinct});
  return true;
}

}  // namespace rbpa
