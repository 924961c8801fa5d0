// What: the edges of the convex hull, so that the largest ball of all need not look for what is not there.
// Law:  has_edge(a, b) exactly if all points lie right of a→b or on its line, and none between a and b.
// Cost: two passes over the points, and m log m for the m points outside an octagon: few in a scattered set, all of
//       them when all lie on a circle.
// Source: Andrew, Another efficient algorithm for convex hulls in two dimensions (1979); Akl, Toussaint, A fast convex
//         hull algorithm (1978).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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
  /// The points that are not surely inside the octagon of those that reach farthest in eight directions.
  static std::vector<Site> outside_of_octagon(std::span<const Point> points) {
    std::array<Site, 8> extreme{};  // counter-clockwise
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
    std::array<Point, 9> corner;
    for (std::size_t i = 0; i < 9; ++i) corner[i] = points[extreme[i % 8]];

    // Most points lie in a disc inside it.
    const Point centre{corner[0].x / 2 + corner[4].x / 2, corner[2].y / 2 + corner[6].y / 2};
    Real radius = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < 8; ++i) {
      const auto side = P::from(corner[i], corner[i + 1]), to = P::from(corner[i], centre);
      if (side.x == 0 && side.y == 0) continue;  // one point is the extreme of two directions
      const Real surely = P::cross(side, to) - 5 * P::unit * P::cross_size(side, to);
      radius = std::min(radius, surely / std::sqrt(P::dot(side, side)));
    }
    const Real in_disc = radius > 0 ? radius * radius * (1 - 64 * P::unit) : 0;

    std::vector<Site> outside;
    for (Site s = 0; s < points.size(); ++s) {
      const auto d = P::from(centre, points[s]);
      if (!(P::dot(d, d) < in_disc) && !is_inside(corner, points[s])) outside.push_back(s);
    }
    return outside;
  }

  /// Surely left of all sides. That turns around the point once or more, wherever the corners are.
  static bool is_inside(const std::array<Point, 9>& corner, const Point& p) {
    for (std::size_t i = 0; i < 8; ++i) {
      const auto side = P::from(corner[i], corner[i + 1]), to = P::from(corner[i], p);
      if (side.x == 0 && side.y == 0) continue;
      if (!(P::cross(side, to) > 5 * P::unit * P::cross_size(side, to))) return false;
    }
    return true;
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
