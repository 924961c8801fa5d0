// What: finds the side of its plane that each point of a closed surface shows to a ball outside. The tree of
//       orient_normals() errs where the two sides of a body are nearer to each other than the points are.
//       do not determine the side there.
// How:  the exposed triangles of the outer shells face outward. The area vectors of the triangles at each point are
//       summed. The sum is clearly on one side of the point's plane if the surface is closed, and near 0 if the ball
//       touches both sides of an open surface. The first ball has a radius of 8 spacings and passes through no gap;
//       smaller balls then see more of the inside of hollows.
// Law:  a function of the neighborhoods. An estimate: a component, connected through nearest points, is judged only if
//       nearly all that the ball sees is one-sided, neighbors hardly contradict each other, and the result contradicts
//       the given normals at more than one point in fifty.
// Cost: small if a sample of the points contradicts no normals; otherwise up to four calls of exposed_triangles(), the
//       first of which is the slowest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/normals/find_nearest.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

/// The outer side of each point. The lists are empty if nothing suggests that normals are wrong.
struct OuterSides {
  /// For each point: 1 if its normal points outward, −1 if inward, 0 if not known or the component's normals are right.
  std::vector<std::int8_t> side;
  /// For each point, the sum of the area vectors of its triangles along its normal, without sign, divided by the sum of
  /// their areas; 0 if the side is 0.
  std::vector<double> vote;

  bool empty() const { return side.empty(); }  ///< whether the lists are empty: no side is known
};

/// Returns the outer sides. Requires: unit normals, in the order of the neighborhoods. Throws: Cancelled.
OuterSides outer_sides(const Neighborhoods& near, std::span<const Point3> normals, const SurfaceOptions& options);

}  // namespace rbpa::space
