// What: draws the mesh of a front.
#pragma once

#include <vector>

#include "drawings/drawn_mesh.h"
#include "meshops/front/front.h"

namespace figures {

/// Returns the present mesh of a front. Fans on one site lie slightly apart, each on its side. Vertices that were
/// merged into others are left out.
DrawnMesh drawn_front(const meshops::Front& front, const Mesh& mesh, const std::vector<Place>& places);

}  // namespace figures
