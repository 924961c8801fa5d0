// What: reserves memory for a mesh before it is built.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Reserves memory for the given total numbers of elements. If the mesh is empty and no number is 0, requests large
/// pages for it (large_pages.h).
MESHOPS_API void reserve(Connectivity& mesh, std::size_t vertices, std::size_t edges, std::size_t faces);

}  // namespace meshops
