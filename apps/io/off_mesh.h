// What: a mesh from an ASCII OFF file.
#pragma once

#include <string>
#include <string_view>

#include "io/read_mesh.h"

namespace rbpa::app {

/// OFF with any of the prefixes ST, C, N; one vertex a line, x y z first, and one face a line, whose colours are passed
/// over. Throws BadInput naming the line; when the file is too short for what it announces, before memory is asked for.
MeshFile read_off_mesh(std::string_view text, const std::string& name);

}  // namespace rbpa::app
