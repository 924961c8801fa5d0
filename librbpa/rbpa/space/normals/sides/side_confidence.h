// What: computes the confidence in the side of each normal that the spanning tree of orient_normals() has oriented.
// How:  an edge of the tree cuts the graph of nearest points in two. Each edge of the graph across the cut votes
//       whether the oriented normals at its ends agree. The confidence at a point is the least agreement of all cuts
//       between the point and the middle of its part of the tree, a vertex at which no cut separates more than half.
// Law:  a function of the neighborhoods, the normals and the tree.
// Cost: O(n log n), in one thread.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/normals/sides/orient_normals.h"
#include "rbpa/space/normals/sides/outer_sides.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"

namespace rbpa::space {

/// Returns the confidence at each point: 1 if all votes agree; 0 if there is no vote, or half of the weight of the
/// votes or more contradicts. In the middle of a part, the confidence is OuterSides::vote of the point at which the
/// part begins, if the side of that point is known, else 1. Calls go_on(), if it is set, repeatedly.
template <typename Real>
std::vector<double> side_confidence(const Neighborhoods& near, std::span<const Point3> normals,
                                    const OrientationTree& tree, const OuterSides& sides, const Checkpoint& go_on);

extern template std::vector<double> side_confidence<double>(const Neighborhoods&, std::span<const Point3>,
                                                            const OrientationTree&, const OuterSides&,
                                                            const Checkpoint&);
extern template std::vector<double> side_confidence<long double>(const Neighborhoods&, std::span<const Point3>,
                                                                 const OrientationTree&, const OuterSides&,
                                                                 const Checkpoint&);

}  // namespace rbpa::space
