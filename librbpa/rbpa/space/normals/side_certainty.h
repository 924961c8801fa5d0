// What: how sure it is on which side of its plane each normal is, once the spanning tree of orient_normals() has turned them.
// How:  an edge of the tree cuts the graph of nearest points in two, and each edge of the graph across that cut is a vote: whether the
//       normals at its ends, as they are turned, agree. A point is as sure as the least sure cut between it and where the tree begins.
// Law:  a function of the neighborhoods, the normals and the tree.
// Cost: O(n log n), in one thread.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/normals/find_nearest.h"
#include "rbpa/space/normals/orient_normals.h"
#include "rbpa/space/normals/outer_sides.h"

namespace rbpa::space {

/// Of each point: 1 where all votes agree, 0 where as many contradict or there is none. Where the tree begins at points whose
/// sides are known, their votes, else 1. Calls go_on() repeatedly, if there is one.
template <typename Real>
std::vector<double> side_certainty(const Neighborhoods& near, std::span<const Point3> normals,
                                   const OrientationTree& tree, const OuterSides& sides,
                                   const std::function<void()>& go_on);

extern template std::vector<double> side_certainty<double>(const Neighborhoods&, std::span<const Point3>,
                                                           const OrientationTree&, const OuterSides&,
                                                           const std::function<void()>&);
extern template std::vector<double> side_certainty<long double>(const Neighborhoods&, std::span<const Point3>,
                                                                const OrientationTree&, const OuterSides&,
                                                                const std::function<void()>&);

}  // namespace rbpa::space
