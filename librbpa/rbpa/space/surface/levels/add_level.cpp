#include "rbpa/space/surface/levels/add_level.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "rbpa/space/surface/facing_sides.h"
#include "rbpa/space/surface/levels/interior.h"
#include "rbpa/space/surface/levels/neighborhood_subset.h"
#include "rbpa/space/surface/levels/sub_surface.h"

namespace rbpa::space {
namespace {

constexpr Triangle no_neighbors = {Surface::none, Surface::none, Surface::none};

/// The addition of the triangles of one radius to a surface, whose triangles are sorted before and after:
///   1. find the surface of the radius near open points that are not interior;
///   2. add those of its triangles that touch no interior point or edge: the candidates;
///   3. glue the sides that face each other at the edges of candidates;
///   4. sort.
class Level {
 public:
  Level(std::span<const Point3> points, std::uint32_t number, Surface& surface)
      : points_(points),
        number_(number),
        surface_(surface),
        old_count_(surface.triangles.size()),
        interior_(arrays_of(surface), points.size()) {}

  void add(std::span<const Point3> normals, double radius, std::vector<std::uint8_t> open,
           const SurfaceOptions& options) {
    for (std::size_t i = 0; i < open.size(); ++i)
      if (interior_.has_point(static_cast<std::uint32_t>(i))) open[i] = 0;
    const NeighborhoodSubset near = neighborhood_subset(points_, normals, surface_.duplicates, open, radius);
    present_ = rbpa::surface(near.points, near.normals, radius, options);
    for (Triangle& triangle : present_.triangles)
      for (std::uint32_t& corner : triangle) corner = near.input[corner];  // the order stays
    add_candidates();
    glue();
    sort();
  }

 private:
  bool is_candidate(const Triangle& t) const {
    if (std::any_of(t.begin(), t.end(), [&](std::uint32_t i) { return interior_.has_point(i); })) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (interior_.has_edge(t[k], t[(k + 1) % 3])) return false;
    return !std::binary_search(surface_.triangles.begin(), surface_.triangles.begin() + static_cast<long>(old_count_),
                               t);
  }

  void add_candidates() {
    for (const Triangle& triangle : present_.triangles) {
      if (!is_candidate(triangle)) continue;
      surface_.triangles.push_back(triangle);
      surface_.neighbors.push_back(no_neighbors);
      surface_.levels.push_back(number_);
    }
  }

  /// Returns all sides at the edges of candidates that are not glued yet.
  std::vector<EdgeSide> open_sides() const {
    std::vector<std::uint8_t> at_candidate(points_.size(), 0);
    for (std::size_t t = old_count_; t < surface_.triangles.size(); ++t)
      for (const std::uint32_t corner : surface_.triangles[t]) at_candidate[corner] = 1;
    std::vector<EdgeSide> sides;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const Triangle& corners = surface_.triangles[t];
        const std::uint32_t from = corners[(k + 1) % 3], to = corners[(k + 2) % 3];
        if (surface_.neighbors[t][k] == Surface::none && at_candidate[from] != 0 && at_candidate[to] != 0)
          sides.push_back({from, to, corners[k], t, k});
      }
    return sides;
  }

  /// Returns the position of triangle t of the surface among the triangles of this radius, or none.
  std::size_t present(std::uint32_t t) const {
    const auto& all = present_.triangles;
    const auto found = std::lower_bound(all.begin(), all.end(), surface_.triangles[t]);
    if (found == all.end() || *found != surface_.triangles[t]) return Surface::none;
    return static_cast<std::size_t>(found - all.begin());
  }

  /// Returns whether two sides that face each other are to be glued: one is a candidate's, and the ball of this radius
  /// rolls from one triangle to the other, or does not rest on one of the triangles.
  bool are_glued(const EdgeSide& s, const EdgeSide& t) const {
    if (s.triangle < old_count_ && t.triangle < old_count_) return false;
    const std::size_t i = present(s.triangle), j = present(t.triangle);
    return i == Surface::none || j == Surface::none || present_.neighbors[i][s.across] == j;
  }

  void glue() {
    std::vector<EdgeSide> sides = open_sides();
    for (const auto& [i, j] : facing_sides(points_, sides)) {
      const EdgeSide &s = sides[i], &t = sides[j];
      if (!are_glued(s, t)) continue;
      surface_.neighbors[s.triangle][s.across] = t.triangle;
      surface_.neighbors[t.triangle][t.across] = s.triangle;
    }
  }

  void sort() {
    const std::size_t count = surface_.triangles.size();
    std::vector<std::uint32_t> order(count), place(count);
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return surface_.triangles[i] < surface_.triangles[j]; });
    for (std::uint32_t i = 0; i < count; ++i) place[order[i]] = i;
    Surface sorted;
    for (const std::uint32_t i : order) {
      sorted.triangles.push_back(surface_.triangles[i]);
      sorted.levels.push_back(surface_.levels[i]);
      Triangle& neighbors = sorted.neighbors.emplace_back(surface_.neighbors[i]);
      for (std::uint32_t& other : neighbors)
        if (other != Surface::none) other = place[other];
    }
    surface_.triangles = std::move(sorted.triangles);
    surface_.neighbors = std::move(sorted.neighbors);
    surface_.levels = std::move(sorted.levels);
  }

  std::span<const Point3> points_;
  std::uint32_t number_;
  Surface& surface_;
  std::size_t old_count_;
  Interior interior_;  // interior of the surface before this level
  Surface present_;    // the surface of this radius, near points that are not interior
};

}  // namespace

void add_level(std::span<const Point3> points, std::span<const Point3> normals, std::uint32_t number, double radius,
               std::vector<std::uint8_t> open, Surface& surface, const SurfaceOptions& options) {
  Level(points, number, surface).add(normals, radius, std::move(open), options);
}

}  // namespace rbpa::space
