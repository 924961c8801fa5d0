// What: a mesh from an STL file, ASCII or binary.
// Law:  corners with equal coordinates are one point (−0 = +0), and nothing else is: what only nearly meets stays
// apart.
#pragma once

#include <string>
#include <string_view>

#include "io/read_mesh.h"

namespace rbpa::app {

/// Points are numbered by their first corner in the file. Binary when the size is that of the number of facets at byte
/// 80, or when it does not begin with "solid", or when there are zero bytes in it; coordinates are then floats, else
/// the doubles nearest to the text. Normals, colours and names are passed over. Throws BadInput naming the line, or the
/// facet of a binary file (counted from 0).
MeshFile read_stl_mesh(std::string_view bytes, const std::string& name);

/// A Claim: the facets of a binary file. ASCII claims nothing.
double claimed_stl_size(std::string_view first, const std::string& name);

}  // namespace rbpa::app
