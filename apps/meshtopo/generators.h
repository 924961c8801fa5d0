// What: short loops that generate the first homology of a surface, as polylines through its points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/mesh/write_mesh.h"
#include "meshops/core/connectivity.h"

namespace rbpa::app {

/// Vertex v of `mesh` stands on point point_of[v]. The basis is short by the lengths of the edges in space, whatever
/// their magnitude. Requires: validate(mesh) is empty; finite positions.
std::vector<Polyline> generators(const meshops::Connectivity& mesh, std::span<const std::uint32_t> point_of,
                                 std::span<const std::array<double, 3>> positions);

}  // namespace rbpa::app
