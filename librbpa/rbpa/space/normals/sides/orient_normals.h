// What:   turns normals to one side, along a minimum spanning tree of the graph of nearest points (Boost.Graph).
// Law:    a function of the neighborhoods: the order of edges of equal weight depends only on the order of the points,
//         which is the order of the k-d tree's leaves.
// Cost:   O(n log n), in one thread.
// Source: Hoppe et al. (1992), section 3.3; the normal at one end is reflected across the edge's middle before it is
//         compared, as in König and Gumhold, Consistent propagation of normal orientations in point clouds (2009),
//         section 2.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"

namespace rbpa::space {

/// A spanning tree of the points and of an additional root, whose number is the number of points. The children of the
/// root are the points at which the tree begins.
struct OrientationTree {
  std::vector<std::uint32_t> order;   ///< the root and all points; each comes after its parent
  std::vector<std::uint32_t> parent;  ///< parent of each point; the root is its own parent
};

/// Turns the normals, one for each point of the neighborhoods, to one side, as estimate_normals() describes, and
/// returns the tree. `sides` is empty, or has OuterSides::side for each point. The tree begins at the points whose side
/// is not 0, and at an extreme point in each component of the graph without such points. Calls go_on(), if it is set,
/// repeatedly.
template <typename Real>
OrientationTree orient_normals(const Neighborhoods& points, std::span<Point3> normals, const Checkpoint& go_on,
                               std::span<const std::int8_t> sides = {});

extern template OrientationTree orient_normals<double>(const Neighborhoods&, std::span<Point3>, const Checkpoint&,
                                                       std::span<const std::int8_t>);
extern template OrientationTree orient_normals<long double>(const Neighborhoods&, std::span<Point3>, const Checkpoint&,
                                                            std::span<const std::int8_t>);

}  // namespace rbpa::space
