// What: finds the rings of exposed triangles around sites.
// Law:  exact and complete: all exposed triangles at each site, and the triangles to which the ball rolls from each.
// How:  1. gather the sites in the cells around a cell, once for all sites in it (surroundings-inl.h);
//       2. find the free region of the ball at each site, by caps (free_region-inl.h), and read the rings off its
//          corners;
//       3. where step 2 cannot decide a sign, or has no room, roll about every edge at the site
//          (pivot/roll_about_edge.h).
// Cost: for each site, two passes over the points in the cells around it, and some hundred operations a triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/space/cells/cells.h"

namespace rbpa::space {

/// Cycles of exposed triangles around sites. Around a site v, the ball rolls in cycles: from the exposed triangle (v,
/// x, y) about x to (v, z, x), and so on. This cycle is stored as y, x, z, …
struct Rings {
  static constexpr Site end_of_cycle = 0xffffffff;

  std::vector<Site> points;          // all cycles of the first site, then those of the next; end_of_cycle after each
  std::vector<std::uint32_t> first;  // for each site, the position in `points` of its first cycle; then points.size()
  std::size_t rolled = 0;            // number of sites at which every edge was rolled about
};

/// Replaces `found` by the rings of the sites first … last − 1.
/// Requires: if `fits_double`, sites and radius fit (cells/scale.h). Throws: Cancelled.
void find_rings(const Cells& cells, bool fits_double, Site first, Site last, Rings& found, meshops::Steps& step);

}  // namespace rbpa::space
