// What: the mesh of a front as it is drawn.
#pragma once

#include <vector>

#include "drawings/drawn_mesh.h"
#include "meshops/front/front.h"

namespace figures {

/// The mesh of a front as it is now. Fans on one site lie slightly apart, each on its side; vertices that merged into
/// others are left out.
DrawnMesh drawn_front(const meshops::Front& front, const Mesh& mesh, const std::vector<Place>& places);

}  // namespace figures
