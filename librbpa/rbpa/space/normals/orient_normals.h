// What:   turns normals to one side, along a minimum spanning tree of the graph of nearest points (Boost.Graph).
// Law:    a function of the neighborhoods: the order of edges of equal weight depends only on the order of the points, which
//         is that of the k-d tree's leaves.
// Cost:   O(n log n), in one thread.
// Source: Hoppe et al. (1992), section 3.3; the normal of one end is compared after reflection across the edge's middle, as
//         in König and Gumhold, Consistent propagation of normal orientations in point clouds (2009), section 2.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/normals/find_nearest.h"

namespace rbpa::space {

/// A spanning tree of the points and a root beside them, whose number is that of the points. The root's children are where it begins.
struct OrientationTree {
  std::vector<std::uint32_t> order;   ///< the root and all points, each behind its parent
  std::vector<std::uint32_t> parent;  ///< of each point, and of the root itself
};

/// Turns the normals, one for each point of the neighborhoods, as estimate_normals() promises. Calls go_on() repeatedly, if
/// there is one. Where the outer side of a point is known, as outer_sides() has it, the tree begins there.
template <typename Real>
OrientationTree orient_normals(const Neighborhoods& points, std::span<Point3> normals,
                               const std::function<void()>& go_on, std::span<const std::int8_t> sides = {});

extern template OrientationTree orient_normals<double>(const Neighborhoods&, std::span<Point3>,
                                                       const std::function<void()>&, std::span<const std::int8_t>);
extern template OrientationTree orient_normals<long double>(const Neighborhoods&, std::span<Point3>,
                                                            const std::function<void()>&, std::span<const std::int8_t>);

}  // namespace rbpa::space
