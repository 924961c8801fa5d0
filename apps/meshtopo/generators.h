// What: loops that generate the first homology of a surface, as polylines through its points.
// Cost: that of meshops::homology_generators(), or of shortest_homology_loops().
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/mesh/write_mesh.h"
#include "meshops/topology/polygon_soup.h"

namespace rbpa::app {

/// Short ones, quickly. Requires: a surface: no defects but pinches, at which it counts as separate; finite positions. Throws
/// Cancelled.
std::vector<Polyline> generators(const meshops::PolygonSoup& soup, std::span<const std::array<double, 3>> positions);

/// Those shorter than `below` of a basis of the least total length, but for rounding, by ascending length. Requires and throws the
/// same.
std::vector<Polyline> shortest_generators(const meshops::PolygonSoup& soup,
                                          std::span<const std::array<double, 3>> positions, double below);

}  // namespace rbpa::app
