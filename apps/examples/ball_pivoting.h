// Ball pivoting in space, after Bernardini, Mittleman, Rushmeier, Silva and Taubin (1999), as a policy of the advancing
// front. Every decision is exact, and the mesh is that of rbpa::surface(): the same triangles, glued at the same sides, on
// any input. Copy and change it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "meshops/front/engine.h"
#include "rbpa/space/rolling_ball.h"

/// A ball of one radius rolls over points with normals, from edge to edge. Sites are input indices.
class BallPivoting {
 public:
  using Triangle = std::array<meshops::Site, 3>;

  explicit BallPivoting(const rbpa::RollingBall& ball) : ball_(ball) {}

  /// Every triangle on which the ball rests is looked at, point by point: no component can be missed.
  std::optional<Triangle> seed(const meshops::Front& front) {
    while (true) {
      for (; !waiting_.empty(); waiting_.pop_back()) {
        const auto [a, b, c] = waiting_.back();
        if (ball_.agrees({a, b, c}) && !front.triangle_on(a, b, c).is_valid()) return waiting_.back();
      }
      if (next_ == ball_.points()) return std::nullopt;
      waiting_ = ball_.triangles_from(next_++);
    }
  }

  /// The ball rests on the triangle behind h, and rolls over h until it touches a point. Where the normals there disagree
  /// with the triangle, the surface ends.
  std::optional<meshops::Site> propose(const meshops::Front& front, meshops::Halfedge h) const {
    const auto p = rolled_over(front, h);
    return p && ball_.agrees({front.from_site(h), front.to_site(h), *p}) ? p : std::nullopt;
  }

  /// A triangle on the same two points is glued to h if it is the one that the ball rolls to. It need not be: sheets touch
  /// along edges, and what hangs over an edge parts the triangles on either side of it.
  bool glues(const meshops::Front& front, meshops::Halfedge h, meshops::Site apex) const {
    return rolled_over(front, h) == apex;
  }

 private:
  std::optional<meshops::Site> rolled_over(const meshops::Front& front, meshops::Halfedge h) const {
    const meshops::Halfedge behind = front.mesh().opposite_halfedge_handle(h);
    const meshops::Site c = front.to_site(front.mesh().next_halfedge_handle(behind));
    return ball_.roll(front.to_site(h), front.from_site(h), c);
  }

  const rbpa::RollingBall& ball_;
  std::vector<Triangle> waiting_;  // of the point before next_
  meshops::Site next_ = 0;
};
