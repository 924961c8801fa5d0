// What: computes loops that generate the first homology of a surface, as polylines along its edges.
// Cost: that of meshops::homology_generators(), shortest_homology_basis() or shortest_homology_loops(), and of
//       loop_kinds().
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
  /// Kind of each loop: "handle", "tunnel", "neither", "both" or "unknown" (meshops::LoopKind).
  std::vector<std::string_view> kinds;
};

/// Returns generators, sorted by kind. With `shortest` they are a basis of the least total length, up to rounding,
/// ascending by length within a kind; otherwise short loops, computed quickly. A pinch counts as one vertex for each
/// fan. Requires: a surface without defects other than pinches; finite positions. Throws Cancelled.
Generators generators(const meshops::PolygonSoup& soup, std::span<const std::array<double, 3>> positions,
                      bool shortest);

/// Returns the loops of a shortest basis that are shorter than `below`, in units of the positions. Requires: as
/// generators(). Throws Cancelled.
std::vector<Polyline> shortest_generators(const meshops::PolygonSoup& soup,
                                          std::span<const std::array<double, 3>> positions, double below);

}  // namespace rbpa::app
