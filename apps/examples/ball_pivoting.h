// Ball pivoting in space, after Bernardini, Mittleman, Rushmeier, Silva and Taubin (1999), as a policy of the advancing
// front, one radius after another. Every decision is exact: on any input, triangles and glued sides equal those of
// rbpa::surface() with the same radii. Copy this file and change it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "meshops/front/engine.h"
#include "rbpa/space/surface/facing_sides.h"
#include "rbpa/space/surface/rolling_ball.h"

/// Policy of a ball that rolls over points with normals, from edge to edge. Each radius is a level of the front, with
/// its own ball and its own policy. Sites are input indices.
class BallPivoting {
 public:
  using Triangle = std::array<meshops::Site, 3>;

  /// Prepares the current level of the front. Requires: `carried` is the result of next_level(). Sites in the interior
  /// of the surface are left out of `carried`, as no ball may roll to them.
  BallPivoting(const rbpa::RollingBall& ball, const meshops::Front& front, std::vector<meshops::Site> carried)
      : ball_(ball), level_(front.level()), open_(std::move(carried)) {
    std::erase_if(open_, [&](meshops::Site s) {
      bool is_interior = false;
      front.for_each_fan(s, [&](meshops::Vertex fan) { is_interior |= !front.mesh().is_boundary(fan); });
      return is_interior;
    });
  }

  /// Returns the next candidate; nothing at the end. Tests all triangles on which the ball rests, point by point, so
  /// that no component is missed.
  std::optional<Triangle> seed(const meshops::Front& front) {
    while (true) {
      for (; !waiting_.empty(); waiting_.pop_back()) {
        const auto [a, b, c] = waiting_.back();
        if (!front.triangle_on(a, b, c).is_valid() && is_candidate(front, waiting_.back())) return waiting_.back();
      }
      if (next_ == open_.size()) return std::nullopt;
      waiting_ = ball_.triangles_from(open_[next_++]);
    }
  }

  /// Proposes the triangle beyond h; nothing if it is not a candidate, so that the surface ends there.
  std::optional<meshops::Site> propose(const meshops::Front& front, meshops::Halfedge h) const {
    const auto p = beyond(front, h);
    return p && is_candidate(front, {front.from_site(h), front.to_site(h), *p}) ? p : std::nullopt;
  }

  /// Returns whether `apex` is the apex of the triangle beyond h; only that triangle is glued to h. Other triangles can
  /// have the two points of h as well: sheets touch along edges, and a triangle that overhangs an edge can lie between
  /// the triangles on both sides of the edge.
  bool glues(const meshops::Front& front, meshops::Halfedge h, meshops::Site apex) const {
    return beyond(front, h) == apex;
  }

 private:
  /// Returns the apex of the triangle beyond h. The ball rests on the triangle behind h, and rolls over h until it
  /// touches a point. If the ball is too large to rest on the triangle behind h, the next candidate around the edge is
  /// taken.
  std::optional<meshops::Site> beyond(const meshops::Front& front, meshops::Halfedge h) const {
    const meshops::Halfedge behind = front.mesh().opposite_halfedge_handle(h);
    const meshops::Site a = front.from_site(behind), b = front.to_site(behind), c = apex(front, behind);
    const auto p = ball_.roll(a, b, c);
    return p ? p : facing(front, a, b, c);
  }

  /// Returns the third corner of the candidate that faces the triangle (a, b, c) across the edge of a and b.
  std::optional<meshops::Site> facing(const meshops::Front& front, meshops::Site a, meshops::Site b,
                                      meshops::Site c) const {
    constexpr std::uint32_t before = 0, candidate = 1;
    std::vector<rbpa::EdgeSide> sides;
    for (const meshops::Halfedge edge : front.edges_between(a, b))
      for (const meshops::Halfedge side : {edge, front.mesh().opposite_halfedge_handle(edge)})
        if (is_of_before(front, side))
          sides.push_back({front.from_site(side), front.to_site(side), apex(front, side), before, 0});
    for (const auto& [from, to] : ball_.rolls(a, b)) {
      if (is_candidate(front, {a, b, from})) sides.push_back({a, b, from, candidate, 0});
      if (is_candidate(front, {b, a, to})) sides.push_back({b, a, to, candidate, 0});
    }
    for (auto [i, j] : rbpa::facing_sides(ball_.points(), sides)) {
      if (sides[i].from != a) std::swap(i, j);
      if (sides[i].apex == c && sides[j].triangle == candidate) return sides[j].apex;
    }
    return std::nullopt;
  }

  /// Returns whether the triangle agrees with the normals, is not of an earlier level, has no edge that two triangles
  /// of earlier levels share, and has no corner that was interior at the beginning of this level.
  bool is_candidate(const meshops::Front& front, const Triangle& t) const {
    for (unsigned i = 0; i < 3; ++i) {
      if (!std::binary_search(open_.begin(), open_.end(), t[i])) return false;
      for (const meshops::Halfedge side : front.edges_between(t[i], t[(i + 1) % 3]))
        if (is_of_before(front, side) && is_of_before(front, front.mesh().opposite_halfedge_handle(side))) return false;
    }
    const meshops::Face there = front.triangle_on(t[0], t[1], t[2]);
    return (!there.is_valid() || front.level(there) == level_) && ball_.agrees(t);
  }

  /// Returns whether a triangle of an earlier level is on the left of h.
  bool is_of_before(const meshops::Front& front, meshops::Halfedge h) const {
    const meshops::Face f = front.mesh().face_handle(h);
    return f.is_valid() && front.level(f) < level_;
  }
  meshops::Site apex(const meshops::Front& front, meshops::Halfedge h) const {
    return front.to_site(front.mesh().next_halfedge_handle(h));
  }

  const rbpa::RollingBall& ball_;
  std::size_t level_;
  std::vector<meshops::Site> open_;  // the carried sites around which no fan closes
  std::vector<Triangle> waiting_;    // triangles at the point before next_ that seed() has yet to test
  std::size_t next_ = 0;
};
