// What: finds the Delaunay tetrahedra of circumradius at most alpha from the triples of points around each point.
// Law:  exact and complete; each tetrahedron is found once. Double precision decides what single precision leaves open,
//       and exact predicates, with the symbolic perturbation, the rest (docs/explanation/space.md, sections 8 to 10).
// How:  four steps for each point v: 1. gather the points within 2 alpha of v, those after v in the order of sites
//       first (near_points-inl.h); 2. list the pairs (q, r) after v, q before r, whose triangle with v may have a
//       circumradius of at most alpha; 3. clip the line of centers x/2 + t n of each triangle by every point p near v:
//       a center is at least as far from p as from v where t b ≤ a. The first p on either side may make a tetrahedron
//       (clip_triples-inl.h); 4. decide each possible tetrahedron in double (apex-inl.h), or else exactly
//       (apex_by_predicates.h).
// Cost: for a point with m points within 2 alpha and P pairs, about P · m / lanes steps of twenty operations.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rbpa/space/cells/cells.h"

namespace rbpa::space {

struct Triples {
  /// The tetrahedra, positively oriented. The first corner of each comes first in the order of sites.
  std::vector<std::array<Site, 4>> tetrahedra;
  std::size_t exact = 0;  ///< number of sides of triangles decided by exact predicates
};

/// Replaces `found` by the tetrahedra whose first corner, in the order of sites, is in cells first_cell … end_cell − 1.
/// Returns false, with `found` incomplete, if more than `most_exact` sides need exact predicates, or the cells around a
/// cell have more than 4,096 points.
/// Requires: `cells` has the radius 2 alpha; sites and radius fit double (cells/scale.h).
bool find_by_triples(const Cells& cells, double alpha, std::size_t first_cell, std::size_t end_cell,
                     std::size_t most_exact, Triples& found);

/// Returns an estimate of the cost of find_by_triples() for all cells, from the numbers of points in cells and a sample
/// of distances. The unit is half a nanosecond to a nanosecond.
/// Cost: some nanoseconds a cell.
double triples_cost(const Cells& cells);

}  // namespace rbpa::space
