// What: finds the Delaunay tetrahedra of circumradius at most alpha from the triples of points around each point.
// Law:  exact and complete; each tetrahedron once. Cases that single precision leaves open go to double precision, and
//       those that double leaves open to exact predicates under the symbolic perturbation (docs/explanation/space.md,
//       sections 8 to 10).
// How:  for each point v, step 1 once for all points of a cell: 1. gather the points after v in the order of sites, and
//       those before v, within 2 alpha (near_points-inl.h); 2. list the pairs (q, r) after v, q before r, whose
//       triangle with v has a circumradius of at most alpha; 3. for a register of such triangles, clip the line of
//       centers x + t n by every point p near v: a center is at least as far from p as from v where t b <= a. The first
//       p on either side makes a tetrahedron (clip_triples-inl.h); 4. compute each possible tetrahedron again in double
//       (apex-inl.h), then exactly (apex_by_predicates.h).
// Cost: for a point with m points within 2 alpha, about (pairs of these) · m / lanes steps of twenty operations.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rbpa/space/cells/cells.h"

namespace rbpa::space {

struct Triples {
  /// The tetrahedra: positively oriented, each with the corner first that is first in the order of sites.
  std::vector<std::array<Site, 4>> tetrahedra;
  std::size_t exact = 0;  ///< number of sides of triples that were decided exactly
};

/// Replaces `found` by the tetrahedra whose first corner, in the order of sites, is in cells first_cell … end_cell − 1.
/// Returns false, with `found` incomplete, if more than `most_exact` sides would have to be decided exactly, or more
/// than 4,096 points are in the cells around a cell.
/// Requires: cells of radius 2 alpha; sites and radius fit double (cells/scale.h).
bool find_by_triples(const Cells& cells, double alpha, std::size_t first_cell, std::size_t end_cell,
                     std::size_t most_exact, Triples& found);

/// Estimates the cost of find_by_triples() for all cells from the numbers of points in cells alone. The unit is half a
/// nanosecond to one.
/// Cost: some nanoseconds a cell.
double triples_cost(const Cells& cells);

}  // namespace rbpa::space
