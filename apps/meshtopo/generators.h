// What: computes loops that generate the first homology of a surface, as polylines along its edges.
// Cost: that of meshops::homology_generators() or shortest_homology_loops(), and of loop_kinds().
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "io/mesh/write_mesh.h"
#include "meshops/topology/polygon_soup.h"

namespace rbpa::app {

struct Generators {
  std::vector<Polyline> loops;
  std::vector<std::string_view>
      kinds;  ///< kind of each loop: "handle", "tunnel", "neither", "both" or "unknown" (meshops::LoopKind)
};

/// Returns generators in the order of their kinds: short loops, computed quickly; or with `shortest` a basis of the
/// least total length, up to rounding, in ascending order of length. At pinches the surface counts as cut apart.
/// Requires: a surface without defects other than pinches; finite positions. Throws Cancelled.
Generators generators(const meshops::PolygonSoup& soup, std::span<const std::array<double, 3>> positions,
                      bool shortest);

/// Returns the loops of a shortest basis that are shorter than `below`. Requires: as generators(). Throws Cancelled.
std::vector<Polyline> shortest_generators(const meshops::PolygonSoup& soup,
                                          std::span<const std::array<double, 3>> positions, double below);

}  // namespace rbpa::app
