// What: reserves memory for a mesh before it is built.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Reserves memory for the given numbers of elements; if the mesh is empty, in large pages where the system has them
/// (large_pages.h).
MESHOPS_API void reserve(Connectivity& mesh, std::size_t vertices, std::size_t edges, std::size_t faces);

}  // namespace meshops
