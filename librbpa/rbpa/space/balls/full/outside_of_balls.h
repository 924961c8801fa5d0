// What: computes the volume of each void of the full alpha complex outside of the balls of radius alpha.
// How:  the volume of the tetrahedra of a void, less the volume of the balls in them by inclusion and exclusion. The
//       share of a tetrahedron in a ball is given by its angles: docs/explanation/space.md, section 21.
// Law:  the choice of simplices is exact; sizes and angles are rounded; their sum is exact and rounded once.
// Cost: linear in the tetrahedra of voids.
// Source: Edelsbrunner, Facello, Fu, Liang, Measuring proteins and voids in proteins (1995).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/balls/full/triangulated.h"

namespace rbpa::space {

/// Returns, for each of `voids` voids, the volume of its part that is at least alpha from every point, in cubed units.
/// Requires: `space` has the tetrahedra of voids, without a neighbor across a triangle of the complex; `void_of` has
///           for each tetrahedron the number of its void; 0 < alpha < infinity unless there are no tetrahedra.
/// Throws: Cancelled.
std::vector<double> outside_of_balls(const Triangulated& space, std::span<const std::uint32_t> void_of,
                                     std::size_t voids, double alpha, Threads& threads, const GoOn& go_on = {});

}  // namespace rbpa::space
