// What: the edges of the convex hull, so that the largest ball of all need not look for what is not there.
// Law:  has_edge(a, b) exactly if all points lie right of a→b or on its line, and none between a and b.
// Cost: two passes over the points, and m log m for the m points outside the octagon of extreme points: few in a
//       scattered set, all of them when all lie on a circle.
// Source: Andrew, Another efficient algorithm for convex hulls in two dimensions (1979); Akl, Toussaint, A fast convex
//         hull algorithm (1978).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rbpa/predicate/predicates.h"

namespace rbpa {

template <typename Real>
class ConvexHull {
 public:
  using Site = std::uint32_t;
  using P = Predicates<Real>;

  /// Requires: distinct points, not all on a line.
  explicit ConvexHull(std::span<const Point> points) {
    std::vector<Site> outer = outside_of_octagon(points);
    std::sort(outer.begin(), outer.end(), [&](Site a, Site b) { return points[a] < points[b]; });
    // Counter-clockwise, below and above, with the points on the sides.
    add_chain(points, outer);
    std::reverse(outer.begin(), outer.end());
    add_chain(points, outer);
    std::sort(edges_.begin(), edges_.end());
  }

  /// A ball that rolls over a→b to the left meets nothing.
  bool has_edge(Site a, Site b) const { return std::binary_search(edges_.begin(), edges_.end(), std::array{a, b}); }

 private:
  static std::vector<Site> outside_of_octagon(std::span<const Point> points) {
    std::array<Site, 8> extreme{};  // in the eight directions, counter-clockwise
    std::array<Real, 8> most;
    most.fill(-std::numeric_limits<Real>::infinity());
    for (Site s = 0; s < points.size(); ++s) {
      const Real x = Real(points[s].x), y = Real(points[s].y), sum = x + y, difference = x - y;
      const std::array<Real, 8> reach{x, sum, y, -difference, -x, -sum, -y, difference};
      for (std::size_t i = 0; i < 8; ++i) {
        if (reach[i] > most[i]) {
          most[i] = reach[i];
          extreme[i] = s;
        }
      }
    }
    // Any eight points of the set will do: what is left of all the lines between them is inside.
    std::vector<Site> corners;
    for (const Site s : extreme)
      if (corners.empty() || (s != corners.back() && s != corners.front())) corners.push_back(s);
    std::vector<Site> outside;
    for (Site s = 0; s < points.size(); ++s) {
      bool inside = corners.size() >= 3;
      for (std::size_t i = 0; inside && i < corners.size(); ++i)
        inside = surely_left(points[corners[i]], points[corners[(i + 1) % corners.size()]], points[s]);
      if (!inside) outside.push_back(s);
    }
    return outside;
  }

  static bool surely_left(const Point& a, const Point& b, const Point& p) {
    const auto ab = P::from(a, b), ap = P::from(a, p);
    return P::cross(ab, ap) > 5 * P::unit * P::cross_size(ab, ap);
  }

  /// The edges of the lower chain of sorted points; of the upper one when they are sorted backward. As the ball rolls
  /// over them from outside: from the later point to the earlier.
  void add_chain(std::span<const Point> points, const std::vector<Site>& sorted) {
    std::vector<Site> chain;
    for (const Site s : sorted) {
      while (chain.size() >= 2 && P::orientation(points[chain[chain.size() - 2]], points[chain.back()], points[s]) < 0)
        chain.pop_back();
      chain.push_back(s);
    }
    for (std::size_t i = 1; i < chain.size(); ++i) edges_.push_back({chain[i], chain[i - 1]});
  }

  std::vector<std::array<Site, 2>> edges_;
};

}  // namespace rbpa
