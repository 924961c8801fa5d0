// What: a mesh from a Wavefront OBJ file.
#pragma once

#include <string>
#include <string_view>

#include "io/read_mesh.h"

namespace rbpa::app {

/// The lines "v x y z …" and "f …"; of a corner v, v/vt, v//vn or v/vt/vn counts v, from 1, or from −1 back from the
/// last vertex before the line. A line that ends in '\' goes on in the next. Everything else is passed over. Throws
/// BadInput naming the line.
MeshFile read_obj_mesh(std::string_view text, const std::string& name);

}  // namespace rbpa::app
