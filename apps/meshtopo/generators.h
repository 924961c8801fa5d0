// What: loops that generate the first homology of a surface, as polylines through its points.
// Cost: that of meshops::homology_generators() or shortest_homology_loops(), and of loop_kinds().
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "io/mesh/write_mesh.h"
#include "meshops/topology/polygon_soup.h"

namespace rbpa::app {

struct Generators {
  std::vector<Polyline> loops;
  std::vector<std::string_view>
      kinds;  ///< of each, "handle", "tunnel", "neither", "both" or "unknown": meshops::LoopKind
};

/// By kinds. Short ones, quickly, or with `shortest` those of a basis of the least total length, but for rounding, by ascending length.
/// Requires: a surface: no defects but pinches, at which it counts as separate; finite positions. Throws Cancelled.
Generators generators(const meshops::PolygonSoup& soup, std::span<const std::array<double, 3>> positions,
                      bool shortest);

/// Those shorter than `below` of the shortest ones. Requires and throws the same.
std::vector<Polyline> shortest_generators(const meshops::PolygonSoup& soup,
                                          std::span<const std::array<double, 3>> positions, double below);

}  // namespace rbpa::app
