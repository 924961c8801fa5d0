#include "meshtopo/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "io/interrupt.h"

namespace rbpa::app {
namespace {

/// A vertex from which a ray goes in the direction of x.
struct Query {
  std::uint32_t surface, vertex;
  std::vector<std::uint32_t> hit = {};      // surfaces, once for each of their triangles
  std::vector<std::uint32_t> touched = {};  // surfaces on which it lies, or may lie
};

/// Queries in squares, as the rays see them.
class Squares {
 public:
  Squares(std::span<const Position> positions, std::vector<Query>& queries) : queries_(queries) {
    for (std::size_t k = 0; k < 2; ++k) {
      least_[k] = std::numeric_limits<double>::infinity();
      greatest_[k] = -least_[k];
      for (const Query& query : queries) {
        least_[k] = std::min(least_[k], positions[query.vertex][k + 1]);
        greatest_[k] = std::max(greatest_[k], positions[query.vertex][k + 1]);
      }
    }
    side_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(queries.size()))) + 1;
    squares_.resize(side_ * side_);
    for (std::uint32_t q = 0; q < queries.size(); ++q) {
      const Position& p = positions[queries[q].vertex];
      squares_[place(0, p[1]) * side_ + place(1, p[2])].push_back(q);
    }
  }

  /// Calls use(query) for each in the squares that a box meets.
  template <typename Use>
  void for_each_in(const Position& low, const Position& high, const Use& use) {
    for (std::size_t k = 0; k < 2; ++k)
      if (high[k + 1] < least_[k] || low[k + 1] > greatest_[k]) return;
    for (std::size_t y = place(0, low[1]); y <= place(0, high[1]); ++y)
      for (std::size_t z = place(1, low[2]); z <= place(1, high[2]); ++z)
        for (const std::uint32_t q : squares_[y * side_ + z]) use(queries_[q]);
  }

 private:
  /// Never descends where a coordinate ascends.
  std::size_t place(std::size_t k, double x) const {
    if (!(x > least_[k])) return 0;
    const double share = (x / 2 - least_[k] / 2) / (greatest_[k] / 2 - least_[k] / 2);
    return share < 1 ? static_cast<std::size_t>(share * static_cast<double>(side_ - 1)) : side_ - 1;
  }

  std::vector<Query>& queries_;
  std::array<double, 2> least_{}, greatest_{};
  std::size_t side_ = 1;
  std::vector<std::vector<std::uint32_t>> squares_;
};

/// The side of a line through two places on which a vertex is that is moved by less than any number, y more than z.
int moved_side(int side, const Position& a, const Position& b) {
  if (side != 0) return side;
  if (a[2] != b[2]) return a[2] < b[2] ? -1 : 1;
  return a[1] == b[1] ? 0 : a[1] < b[1] ? 1 : -1;
}

void shoot(Query& query, std::uint32_t surface, std::span<const Position> positions, const Triangle& triangle) {
  const Position &p = positions[query.vertex], &a = positions[triangle[0]], &b = positions[triangle[1]],
                 &c = positions[triangle[2]];
  const std::array sides = {side_along_x(a, b, p), side_along_x(b, c, p), side_along_x(c, a, p)};
  const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
  if (*low < 0 && *high > 0) return;  // the ray passes beside it
  const bool is_seen_from_its_side = *low == 0 && *high == 0;
  const int above = is_seen_from_its_side ? 0 : side_of_plane(a, b, c, p);
  if (above == 0) {
    if (p[0] >= std::min({a[0], b[0], c[0]}) && p[0] <= std::max({a[0], b[0], c[0]})) query.touched.push_back(surface);
    return;
  }
  const int first = moved_side(sides[0], a, b);
  if (first == moved_side(sides[1], b, c) && first == moved_side(sides[2], c, a) && first * above < 0)
    query.hit.push_back(surface);
}

void shoot_all(std::span<const Position> positions, std::span<const std::vector<Triangle>> surfaces,
               std::vector<Query>& queries) {
  Squares squares(positions, queries);
  std::size_t done = 0;
  for (std::uint32_t s = 0; s < surfaces.size(); ++s)
    for (const Triangle& triangle : surfaces[s]) {
      if (++done % 1024 == 0) stop_if_interrupted();
      Position low = positions[triangle[0]], high = low;
      for (const std::uint32_t corner : triangle)
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], positions[corner][k]);
          high[k] = std::max(high[k], positions[corner][k]);
        }
      squares.for_each_in(low, high, [&](Query& query) {
        const Position& p = positions[query.vertex];
        if (query.surface == s || p[0] > high[0]) return;
        if (p[1] < low[1] || p[1] > high[1] || p[2] < low[2] || p[2] > high[2]) return;
        shoot(query, s, positions, triangle);
      });
    }
}

/// Surfaces that are hit an odd number of times and not touched.
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

std::vector<std::size_t> depths(std::span<const Position> positions, std::span<const std::vector<Triangle>> surfaces) {
  std::vector<std::size_t> result(surfaces.size(), 0);
  std::vector<std::vector<std::uint32_t>> vertices(surfaces.size());  // that are not asked yet, the next one last
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    stop_if_interrupted();
    for (const Triangle& triangle : surfaces[s])
      vertices[s].insert(vertices[s].end(), triangle.begin(), triangle.end());
    std::sort(vertices[s].begin(), vertices[s].end(),
              [&](std::uint32_t a, std::uint32_t b) { return positions[a] > positions[b]; });
    const auto is_same = [&](std::uint32_t a, std::uint32_t b) { return positions[a] == positions[b]; };
    vertices[s].erase(std::unique(vertices[s].begin(), vertices[s].end(), is_same), vertices[s].end());
  }
  std::vector<bool> is_known(surfaces.size(), false), is_asked(surfaces.size(), false);
  // Nearly all first vertices touch nothing; of those that do more and more are asked at a time.
  for (std::size_t at_once = 1;; at_once *= 2) {
    std::vector<Query> queries;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s)
      for (std::size_t i = 0; i < at_once && !is_known[s] && !vertices[s].empty(); ++i) {
        queries.push_back({s, vertices[s].back()});
        vertices[s].pop_back();
      }
    if (queries.empty()) return result;
    shoot_all(positions, surfaces, queries);
    for (Query& query : queries) {
      if (is_known[query.surface]) continue;
      is_known[query.surface] = query.touched.empty();
      if (is_known[query.surface] || !is_asked[query.surface]) result[query.surface] = depth_of(query);
      is_asked[query.surface] = true;
    }
  }
}

}  // namespace rbpa::app
