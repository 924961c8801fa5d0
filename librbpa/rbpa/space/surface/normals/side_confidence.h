// What: the confidence in the orientation of each normal, after the spanning tree of orient_normals() has oriented
//       them.
// How:  an edge of the tree cuts the graph of nearest points in two. Each edge of the graph across the cut is a vote:
//       whether the oriented normals at its ends agree. The confidence at a point is the least one of all cuts between
//       it and the beginning of the tree.
// Law:  a function of the neighborhoods, the normals and the tree.
// Cost: O(n log n), in one thread.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/normals/find_nearest.h"
#include "rbpa/space/surface/normals/orient_normals.h"
#include "rbpa/space/surface/normals/outer_sides.h"

namespace rbpa::space {

/// Returns the confidence at each point: 1 where all votes agree, 0 where as many contradict or there is no vote. At
/// points where the tree begins it is their vote if their sides are known, else 1. Calls go_on(), if any, repeatedly.
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
