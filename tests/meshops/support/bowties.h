// Meshes in which the fans at a vertex touch: what OpenMesh's add_face() makes of faces that meet in a point.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "meshops/core/connectivity.h"
#include "support/meshes.h"

namespace meshops::test {

/// Makes one vertex of two on the boundary: their fans are linked in one ring, as OpenMesh does. The other one is
/// marked deleted.
void tie(Connectivity& mesh, Vertex stays, Vertex goes);

/// Makes one vertex of all that stand on one point, the first of each point; their fans are in one ring where they are
/// open, and in rings of their own where they close.
void tie_points(Connectivity& mesh, const std::vector<std::uint32_t>& point_of_vertex);

/// Ties random pairs of boundary vertices that no edge joins. Returns how many.
int tie_at_random(Connectivity& mesh, int attempts, std::mt19937& random);

}  // namespace meshops::test
