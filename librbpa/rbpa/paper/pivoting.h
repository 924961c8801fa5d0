// What:   RBPA: restricted ball pivoting as a policy of the advancing-front engine.
// Law:    Theorem 1: an empty front becomes the solid alpha complex. A front that is the complex of a smaller radius
//         becomes the complex of radius α, although the policy reads only boundary and isolated points.
// Cost:   a pivot for each triangle and each boundary edge, a roll or two for each boundary or isolated point: linear
//         if #V_p is bounded (section 5).
// Source: Restricted BPA, sections 3 and 4.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "meshops/front/front.h"
#include "rbpa/paper/circle.h"
#include "rbpa/plane/mesh/monitor.h"

namespace rbpa::paper {

using meshops::Front;
using meshops::Halfedge;
using Triangle = std::array<Site, 3>;  ///< counter-clockwise

class RestrictedBallPivoting {
 public:
  /// Takes `sites`, the sites of the front that are isolated or on the boundary. Keeps the span `points`. Calls
  /// observe(front), unless it is empty, for each proposal and for each site at which seed() searches; an exception of
  /// observe() ends the run. Requires: the points are distinct and not all on a line.
  RestrictedBallPivoting(std::span<const Point> points, std::vector<Site> sites, Radius alpha,
                         std::function<void(const Front&)> observe = {})
      : sites_(std::move(sites)), ball_(points, sites_, alpha), observe_(std::move(observe)) {}
  RestrictedBallPivoting(const RestrictedBallPivoting&) = delete;
  RestrictedBallPivoting& operator=(const RestrictedBallPivoting&) = delete;

  /// Returns the point that the ball touches first when it pivots on the boundary edge of `h` (the geometric step,
  /// section 3.1); nothing if the ball touches no point.
  std::optional<Site> propose(const Front& front, Halfedge h);

  /// Returns an ideal seed (section 4): a triangle of the complex with no edge in the mesh; nothing if and only if no
  /// ideal seed exists.
  /// Requires: no halfedge of the front is active.
  std::optional<Triangle> seed(const Front& front);

 private:
  std::optional<Triangle> seed_at_isolated(const Front& front, Site v) const;
  std::optional<Triangle> seed_at_boundary(const Front& front, Site v) const;
  std::optional<Triangle> roll_to_seed(const Front& front, Site v, Site from) const;
  std::optional<Triangle> triangle_left_of(Site a, Site b) const;

  std::vector<Site> sites_;
  Ball ball_;
  std::function<void(const Front&)> observe_;
  std::size_t next_ = 0;  // position in sites_; no triangle is missing at the sites before
};

/// Computes the solid alpha complex of the points, by RBPA with one radius.
/// Requires: `points` are distinct and not all on a line; `front` is empty, and site i is point i.
/// Throws:   any exception of `monitor`.
void rbpa(std::span<const Point> points, Radius alpha, Front& front, Monitor& monitor);

}  // namespace rbpa::paper
