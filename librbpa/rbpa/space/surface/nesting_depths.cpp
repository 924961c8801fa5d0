#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/ray_along_x.h"
#include "rbpa/space/surface/outer_shells.h"

namespace rbpa {
namespace {

/// A corner of a surface, from which a ray starts in the direction of +x.
struct Query {
  std::uint32_t surface, corner;
  std::vector<std::uint32_t> hit = {};      // surfaces that the ray hits, once for each triangle hit
  std::vector<std::uint32_t> touched = {};  // surfaces on which the corner lies
};

/// Queries in the squares of a grid in y and z, perpendicular to the rays.
class Squares {
 public:
  Squares(std::span<const Point3> points, std::vector<Query>& queries) : queries_(queries) {
    for (const Query& query : queries) box_.include(points[query.corner]);
    side_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(queries.size()))) + 1;
    squares_.resize(side_ * side_);
    for (std::uint32_t q = 0; q < queries.size(); ++q) {
      const Point3& p = points[queries[q].corner];
      squares_[at_y(p.y) * side_ + at_z(p.z)].push_back(q);
    }
  }

  /// Calls use(query) for each query in the squares that a box meets.
  template <typename Use>
  void for_each_in(const space::Box& box, const Use& use) {
    if (box.high.y < box_.low.y || box.low.y > box_.high.y || box.high.z < box_.low.z || box.low.z > box_.high.z)
      return;
    for (std::size_t y = at_y(box.low.y); y <= at_y(box.high.y); ++y)
      for (std::size_t z = at_z(box.low.z); z <= at_z(box.high.z); ++z)
        for (const std::uint32_t q : squares_[y * side_ + z]) use(queries_[q]);
  }

 private:
  std::size_t at_y(double y) const { return place(y, box_.low.y, box_.high.y); }
  std::size_t at_z(double z) const { return place(z, box_.low.z, box_.high.z); }
  /// Returns the number, along an axis, of the square that contains a coordinate. The function is monotone.
  std::size_t place(double x, double least, double greatest) const {
    if (!(x > least)) return 0;
    const double share = (x / 2 - least / 2) / (greatest / 2 - least / 2);
    return share < 1 ? static_cast<std::size_t>(share * static_cast<double>(side_ - 1)) : side_ - 1;
  }

  std::vector<Query>& queries_;
  space::Box box_ = {};
  std::size_t side_ = 1;
  std::vector<std::vector<std::uint32_t>> squares_;
};

/// Returns whether p is in the triangle, its sides included. Requires: p is in the plane and in the bounding box of the
/// triangle.
bool is_on(const std::array<Point3, 3>& t, const Point3& p) {
  for (const int axis : {0, 1, 2}) {
    const auto [low, high] =
        std::minmax({space::orientation_along(t[0], t[1], p, axis), space::orientation_along(t[1], t[2], p, axis),
                     space::orientation_along(t[2], t[0], p, axis)});
    if (low < 0 && high > 0) return false;
  }
  return true;
}

void shoot(Query& query, std::uint32_t surface, const Point3& p, const std::array<Point3, 3>& t,
           const space::Box& box) {
  const std::array sides = {space::orientation_along(t[0], t[1], p, 0), space::orientation_along(t[1], t[2], p, 0),
                            space::orientation_along(t[2], t[0], p, 0)};
  const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
  if (*low < 0 && *high > 0) return;  // the ray misses the triangle
  const bool is_seen_from_its_side = *low == 0 && *high == 0;
  const int above = is_seen_from_its_side ? 0 : space::orientation(t[0], t[1], t[2], p);
  if (above == 0) {
    if (p.x >= box.low.x && is_on(t, p)) query.touched.push_back(surface);
    return;
  }
  const int first = space::moved_side(sides[0], t[0], t[1]);
  if (first == space::moved_side(sides[1], t[1], t[2]) && first == space::moved_side(sides[2], t[2], t[0]) &&
      first * above < 0)
    query.hit.push_back(surface);
}

void shoot_all(std::span<const Point3> points, std::span<const std::vector<Triangle>> surfaces,
               std::vector<Query>& queries, Steps& step) {
  Squares squares(points, queries);
  for (std::uint32_t s = 0; s < surfaces.size(); ++s)
    for (const auto& [a, b, c] : surfaces[s]) {
      step();
      const std::array corners = {points[a], points[b], points[c]};
      const space::Box box = space::box_of(corners);
      squares.for_each_in(box, [&](Query& query) {
        step();
        const Point3& p = points[query.corner];
        if (query.surface == s || p.x > box.high.x) return;
        if (p.y < box.low.y || p.y > box.high.y || p.z < box.low.z || p.z > box.high.z) return;
        shoot(query, s, p, corners, box);
      });
    }
}

/// Returns the number of surfaces that the ray hits an odd number of times and on which the corner does not lie.
std::size_t depth_of(Query& query) {
  std::sort(query.hit.begin(), query.hit.end());
  std::size_t depth = 0;
  for (auto first = query.hit.begin(); first != query.hit.end();) {
    const auto last = std::upper_bound(first, query.hit.end(), *first);
    const bool is_touched = std::find(query.touched.begin(), query.touched.end(), *first) != query.touched.end();
    if ((last - first) % 2 == 1 && !is_touched) ++depth;
    first = last;
  }
  return depth;
}

}  // namespace

std::vector<std::size_t> nesting_depths(std::span<const Point3> points, std::span<const std::vector<Triangle>> surfaces,
                                        const GoOn& go_on) {
  Steps step(go_on);
  std::vector<std::size_t> result(surfaces.size(), 0);
  std::vector<std::vector<std::uint32_t>> corners(surfaces.size());  // untried corners; the next one is last
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    for (const Triangle& triangle : surfaces[s]) {
      step();
      for (const std::uint32_t corner : triangle) {
        meshops::require(corner < points.size(), "nesting_depths: a triangle has a corner that is not a point");
        corners[s].push_back(corner);
      }
    }
    sort(corners[s], step, [&](std::uint32_t a, std::uint32_t b) { return points[b] < points[a]; });
    const auto is_same = [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; };
    corners[s].erase(std::unique(corners[s].begin(), corners[s].end(), is_same), corners[s].end());
  }
  std::vector<bool> is_known(surfaces.size(), false), is_asked(surfaces.size(), false);
  // Nearly all first corners lie on no other surface. For the rest, twice as many corners are tried each time.
  for (std::size_t at_once = 1;; at_once *= 2) {
    std::vector<Query> queries;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s)
      for (std::size_t i = 0; i < at_once && !is_known[s] && !corners[s].empty(); ++i) {
        queries.push_back({s, corners[s].back()});
        corners[s].pop_back();
      }
    if (queries.empty()) return result;
    shoot_all(points, surfaces, queries, step);
    for (Query& query : queries) {
      if (is_known[query.surface]) continue;
      is_known[query.surface] = query.touched.empty();
      if (is_known[query.surface] || !is_asked[query.surface]) result[query.surface] = depth_of(query);
      is_asked[query.surface] = true;
    }
  }
}

}  // namespace rbpa
