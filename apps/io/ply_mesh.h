// What: a mesh from a PLY file, ASCII or binary.
#pragma once

#include <string>
#include <string_view>

#include "io/read_mesh.h"

namespace rbpa::app {

/// The number properties x, y, z of the element "vertex" and the list vertex_indices or vertex_index of the element
/// "face", of any number types and in either order; without faces, points alone. Everything else is passed over, but
/// has to be there, so that a cut file is noticed. Triangle strips are not read. Throws BadInput naming the line, or
/// the element of a binary file (counted from 0); when the file is too short for what the header announces, before
/// memory is asked for.
MeshFile read_ply_mesh(std::string_view bytes, const std::string& name);

}  // namespace rbpa::app
