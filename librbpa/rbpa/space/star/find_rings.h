// What: the rings of exposed triangles around sites.
// Law:  exact, and complete: all exposed triangles at each site, and to which of them the ball rolls.
// How:  the free region of the ball at each site, by caps (star/free_region-inl.h); where that is lost, every edge is rolled
//       about (pivot/roll_about_edge.h).
// Cost: for each site, a look at the points in the cells around it, and some hundred operations for each of its triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/space/cells/cells.h"

namespace rbpa::space {

/// Around a site v the ball rolls in cycles: from the exposed triangle (v, x, y) about x to (v, z, x), and so on. A cycle is
/// written y, x, z, …
struct Rings {
  static constexpr Site end_of_cycle = 0xffffffff;

  std::vector<Site> points;          // each cycle, and its end
  std::vector<std::uint32_t> first;  // in points, of each site, and the end of the last
  std::size_t rolled = 0;            // sites at which every edge was rolled about
};

/// Replaces `found` by the rings of the sites first … last − 1.
/// Requires: where `fits_double`, it holds for sites and radius (search/scale.h).
void find_rings(const Cells& cells, bool fits_double, Site first, Site last, Rings& found);

}  // namespace rbpa::space
