// What: reserves memory for a mesh before it is built.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Reserves memory for the given total numbers of elements and for their properties. If the mesh has no elements and
/// none of the three numbers is 0, the function also requests large pages for the arrays of links (core/large_pages.h).
/// Never frees memory; links and properties keep their values.
MESHOPS_API void reserve(Connectivity& mesh, std::size_t vertices, std::size_t edges, std::size_t faces);

}  // namespace meshops
