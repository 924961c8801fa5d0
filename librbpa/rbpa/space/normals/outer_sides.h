// What: which side of its plane each point of a closed surface shows to a ball outside. The tree of orient_normals() errs where the
//       two sides of a body are nearer to each other than the points are: there neighbors do not determine the side.
// How:  the exposed triangles of the outer shells face outward. The normals of a point's triangles, weighted by area, are summed:
//       the sum is on one side of its plane where the surface is closed, and near 0 where the ball touches both sides of an open
//       one. First a ball of 8 spacings, which slips through no gap; then smaller ones, which see more of what lies in hollows.
// Law:  a function of the neighborhoods. An estimate: a component, connected through nearest points, is judged only where
//       nearly all that the ball sees is one-sided and neighbors hardly contradict each other, and where this contradicts the
//       normals given for more than one point in fifty.
// Cost: small where a sample of the points contradicts no normals; else up to four times that of exposed_triangles(), of which the first
//       is the slowest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/normals/find_nearest.h"
#include "rbpa/surface.h"

namespace rbpa::space {

/// Of each point.
struct OuterSides {
  std::vector<std::int8_t>
      side;  ///< 1: that of its normal is outside, −1: the other one, 0: not known, or its component's normals are right
  std::vector<double> vote;  ///< what the sum of its triangles has along the normal, of their area; 0 where the side is

  bool empty() const { return side.empty(); }  ///< all sides are 0
};

/// Requires: unit normals, in the order of the neighborhoods. Throws: Cancelled.
OuterSides outer_sides(const Neighborhoods& near, std::span<const Point3> normals, const SurfaceOptions& options);

}  // namespace rbpa::space
