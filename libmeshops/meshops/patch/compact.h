// What: removes the vertices without triangles from a mesh that stands on sites.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/patch/site_vertices.h"

namespace meshops::detail {

/// Removes the vertices without triangles and renumbers the others, which keep their order and properties. The mesh
/// keeps only its first `edges` edges and `faces` faces.
/// Returns: the site of each remaining vertex. `vertices` cannot be used afterwards.
/// Cost:    linear; small if only the last vertices are to be removed.
std::vector<Site> compact(Connectivity& mesh, const SiteVertices& vertices, std::size_t edges, std::size_t faces);

}  // namespace meshops::detail
