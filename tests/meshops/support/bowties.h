// Makes meshes in which the fans at a vertex touch, as OpenMesh's add_face() makes them of faces that meet in a point.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "meshops/core/connectivity.h"
#include "support/meshes.h"

namespace meshops::test {

/// Merges two boundary vertices: their fans are linked in one ring, as OpenMesh does. The other vertex is
/// marked deleted.
void tie(Connectivity& mesh, Vertex stays, Vertex goes);

/// Merges all vertices that stand on one point into the first of them. Open fans are linked in one ring; closed fans
/// keep rings of their own.
void tie_points(Connectivity& mesh, const std::vector<std::uint32_t>& point_of_vertex);

/// Ties random pairs of boundary vertices that no edge joins. Returns: their number.
int tie_at_random(Connectivity& mesh, int attempts, std::mt19937& random);

}  // namespace meshops::test
